package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.AgentlessSite;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.language.Language;
import org.maestro.language.grammar.Grammar;
import org.maestro.language.hearing.HeardWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** Why goals fail and are planned again is told in German where German is spoken. */
class GermanReasonsTest {
  private static final Duration LIMIT = Duration.ofMinutes(5);
  private static final Pattern WORD = Pattern.compile("[\\p{L}]{2,}");

  /** Words that both languages have. */
  private static final Set<String> SHARED =
      Set.of("in", "so", "an", "am", "es", "was", "war", "kg", "plan");

  private static final String GERMAN =
      """

      <https://w3id.org/maestro/home/bob> maestro:language "de" .
      """;
  private static final String HALF =
      """

      home:halbe-kraft a maestro:Permission ; maestro:person "*" ; maestro:asks :Lamp ;
        maestro:permits :adjustLight ; maestro:when "(<= ?level 0.5)" .
      """;

  /** A goal that has ended, and all that was told of it, in German. */
  private record Told(GoalOutcome outcome, List<String> reasons, List<String> story) {}

  private static Told pursued(String scene, String more, String goal, Happening happening)
      throws IOException {
    Home home = new HomeLoader().load(text("/homes/bob.ttl") + GERMAN + more, "bob.ttl");
    GoalWords words =
        new GoalWords(
            home,
            Language.of(home, Language.spoken(home, Optional.empty())).grammar(),
            Optional.empty());
    try (InputStream turtle =
            GermanReasonsTest.class.getResourceAsStream("/scenes/" + scene + ".ttl");
        AgentlessSite site =
            AgentlessSite.start(home, SceneLoader.load(scene + ".ttl", turtle, home), 1)) {
      List<GoalOutcome> outcomes = new ArrayList<>();
      String id = site.pursue(goal, outcomes::add);
      happening.during(site, id);
      site.runUntil(() -> !outcomes.isEmpty(), LIMIT);
      assertThat(outcomes).hasSize(1);
      return new Told(
          outcomes.get(0),
          outcomes.get(0).reasons().stream().map(words::report).toList(),
          site.story().stream().map(StoryEntry::text).map(words::report).toList());
    }
  }

  /** What happens meanwhile. */
  private interface Happening {
    void during(AgentlessSite site, String goal);
  }

  private static String text(String resource) throws IOException {
    try (InputStream turtle = GermanReasonsTest.class.getResourceAsStream(resource)) {
      return new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
    }
  }

  private static Told pursued(String scene, String more, String goal) throws IOException {
    return pursued(scene, more, goal, (site, id) -> {});
  }

  private static Grammar grammar(String language) throws IOException {
    return Language.of(new HomeLoader().load(text("/homes/bob.ttl"), "bob.ttl"), language)
        .grammar();
  }

  private static Set<String> words(Stream<String> texts) {
    return texts
        .flatMap(
            one -> WORD.matcher(one).results().map(word -> word.group().toLowerCase(Locale.ROOT)))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** With words of English rules and reports that German rules do not have. */
  private static void assertWhollyGerman(List<String> told) throws IOException {
    Set<String> english = words(HeardWords.wordsOf(grammar("en")).stream());
    english.addAll(
        words(
            grammar("de").reports().stream()
                .map(rule -> rule.text().replaceAll("[{][^{}]*}", ""))));
    english.removeAll(words(HeardWords.wordsOf(grammar("de")).stream()));
    english.removeAll(SHARED);
    assertThat(english).contains("nobody", "needed", "because", "is", "the");

    assertThat(told).isNotEmpty().noneMatch(text -> text.contains("auf Englisch"));
    Set<String> said = words(told.stream());
    said.retainAll(english);
    assertThat(said).as(String.join("\n", told)).isEmpty();
  }

  @Test
  void whatNobodyCanDo() throws IOException {
    Told told = pursued("bob-dark", "", "(not (open door-ab))");

    assertThat(told.reasons())
        .containsExactly("Niemand kann das bewirken: die Tür zwischen A und B ist geschlossen.");
    assertWhollyGerman(told.story());
  }

  @Test
  void whatIsForbidden() throws IOException {
    Told told = pursued("bob-dark", HALF, "(= (level lamp-b1) 1)");

    assertThat(told.reasons())
        .containsExactly(
            "Wer nicht bekannt ist, darf die Helligkeit von Lampe B1 auf höchstens 0,5 stellen. Das steht in bob.ttl (halbe-kraft).");
    assertWhollyGerman(told.reasons());
  }

  @Test
  void whatLampsDoNotGive() throws IOException {
    Told told = pursued("bob-dark", HALF, "(>= (illuminance zone-b) 72)");

    assertThat(told.outcome().reached()).isFalse();
    assertThat(told.reasons())
        .containsExactly(
            "Die Beleuchtungsstärke von Raum B muss mindestens 72 lux sein; höchstens 63,61 lux ist möglich. "
                + "Es ginge, wenn das so wäre: die Beleuchtungsstärke von Raum B ist um 8,39 lux höher.");
    assertWhollyGerman(told.reasons());
  }

  @Test
  void whatIsLookedForInVain() throws IOException {
    Told told = pursued("bob-hidden", "", "(nextTo Cup Bob)");

    assertThat(told.outcome().reached()).isFalse();
    assertWhollyGerman(told.story());
  }

  @Test
  void whatFailsAndIsPlannedAgain() throws IOException {
    Told told = pursued("bob-weak-lamps", "", "(nextTo Cup Bob)");

    assertThat(told.outcome().reached()).isTrue();
    assertThat(told.story())
        .anyMatch(text -> text.startsWith("Das ging nicht: Kamera B sagt: 49,8 Lux in Raum B"))
        .anyMatch(text -> text.startsWith("Es wird neu geplant. Der Grund: "));
    assertWhollyGerman(told.story());
  }

  @Test
  void whatIsCalledOff() throws IOException {
    Told told =
        pursued(
            "bob-dark", "", "(nextTo Cup Bob)", (site, id) -> site.coordinator().cancel(id, "Bob"));

    assertThat(told.reasons()).containsExactly("Abgesagt von Bob.");
    assertWhollyGerman(told.story());
  }
}
