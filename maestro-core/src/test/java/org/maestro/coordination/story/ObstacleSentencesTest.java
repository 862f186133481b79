package org.maestro.coordination.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.PretendHouse;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.PlanningResult.Cure;
import org.maestro.planning.api.PlanningResult.Explanation;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Extent;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Term;

/** A number is called a limit only where it is one, and by whose help. */
class ObstacleSentencesTest {

  @Test
  void whatIsProvenIsALimit() throws IOException {
    assertThat(said("(>= (illuminance zone-b) 72)", "60", Extent.LIMIT))
        .contains("has to be at least 72 lux, and it can be 60 lux at most.");
    assertThat(said("(<= (illuminance zone-b) 10)", "17", Extent.LIMIT))
        .contains("has to be at most 10 lux, and it can be no less than 17 lux.");
  }

  @Test
  void whatOthersCouldChangeIsALimitAsThingsAreNow() throws IOException {
    assertThat(said("(>= (illuminance zone-b) 72)", "60", Extent.LIMIT_NOW))
        .contains("and as things are now it can be 60 lux at most.");
  }

  @Test
  void whatIsNotProvenIsNoLimit() throws IOException {
    assertThat(said("(>= (illuminance zone-b) 72)", "60", Extent.FOUND))
        .contains("and no way was found to bring it above 60 lux.")
        .doesNotContain("can be");
    assertThat(said("(>= (illuminance zone-b) 72)", "60", Extent.KNOWN))
        .contains("and it is 60 lux.")
        .doesNotContain("can be");
  }

  /** It is that device's word; another might say otherwise. */
  @Test
  void whoMeasuredWhatIsNotEnoughIsNamed() throws IOException {
    KnowledgeBase knowledge = new PretendHouse(home()).knowledge;
    knowledge.state(
        new Source(Source.Kind.OBSERVED, "lux-b"), List.of("(= (illuminance zone-b) 60)"));

    assertThat(
            new ObstacleSentences(home(), knowledge.snapshot())
                .obstacle(number("(>= (illuminance zone-b) 72)", "60", Extent.LIMIT)))
        .contains("and it is 60 lux as lux-b measured, and nobody can make it more.");
    assertThat(
            new ObstacleSentences(home(), knowledge.snapshot())
                .obstacle(number("(>= (illuminance zone-b) 72)", "66", Extent.LIMIT)))
        .as("nobody measured 66")
        .contains("and it can be 66 lux at most.");
  }

  /** Each would be possible without the other. */
  @Test
  void whatIsOutOfReachOnlyBesideTheRestIsToldSo() throws IOException {
    assertThat(said("(>= (illuminance zone-b) 72)", "80", Extent.LIMIT))
        .contains("and it can be 80 lux, but not together with all else that is needed.");
  }

  /** Who is away might do it, and who refuses. */
  @Test
  void whatOthersCouldDoIsOutOfReachAsThingsAreNow() throws IOException {
    assertThat(said(Kind.GOAL, "(nextTo Cup Bob)", "false", Extent.LIMIT_NOW))
        .isEqualTo("As things are now nobody can bring it about that Cup is next to Bob.");
    assertThat(said(Kind.GOAL, "(nextTo Cup Bob)", "false", Extent.LIMIT))
        .isEqualTo("Nobody can bring it about that Cup is next to Bob.");
    assertThat(said(Kind.UNKNOWN, "(in Cup zone-b)", "unknown", Extent.LIMIT_NOW))
        .startsWith(
            "It is not known that Cup is in zone-b; as things are now nobody can find out.");
  }

  /** It has failed, and has left since. */
  @Test
  void whoIsGoneIsNotNamedAsWhoCouldDoItAfterAll() throws IOException {
    StepKey step = new StepKey("rose", "pickUp", Map.of("object", new Term.Name("Cup")));
    Obstacle failed = obstacle(Kind.STEP, "rose picks up Cup", "it failed twice", step);
    Obstacle absent =
        obstacle(Kind.MEMBER, "rose", "lost since 3 s", new StepKey("rose", "", Map.of()));
    ObstacleSentences sentences = sentences();

    assertThat(sentences.all(new Explanation(List.of(failed), true)))
        .singleElement()
        .asString()
        .contains("It would do if rose did it after all");
    assertThat(sentences.all(new Explanation(List.of(failed, absent), true)))
        .first()
        .asString()
        .contains("It would do if rose were there and did it after all");
  }

  @Test
  void atMostFiveWaysAreToldAndHowManyMoreThereAre() throws IOException {
    Obstacle dark = number("(>= (illuminance zone-b) 72)");
    List<Cure> seven =
        IntStream.rangeClosed(1, 7)
            .mapToObj(number -> number("(>= (illuminance zone-a) %d)".formatted(number)))
            .map(other -> new Cure(List.of(other)))
            .toList();

    String told = sentences().obstacle(dark.withCures(seven));
    assertThat(told)
        .contains("illuminance of zone-a were at least 4 lux, or in 3 other ways.")
        .doesNotContain("at least 5 lux");
    assertThat(sentences().obstacle(dark.withCures(seven.subList(0, 4))))
        .contains("or if the illuminance of zone-a were at least 4 lux.");
    assertThat(sentences().obstacle(dark.withCures(Collections.nCopies(7, seven.get(0)))))
        .as("what reads the same is told once")
        .endsWith("or if the illuminance of zone-a were at least 1 lux.")
        .containsOnlyOnce("zone-a");
  }

  private static Obstacle number(String condition) {
    return number(condition, "0", Extent.KNOWN);
  }

  private static Obstacle number(String condition, String possible, Extent extent) {
    return new Obstacle(
        Kind.NUMBER,
        condition,
        "",
        possible,
        extent,
        OptionalDouble.empty(),
        Optional.empty(),
        Optional.empty(),
        List.of());
  }

  private static Obstacle obstacle(Kind kind, String what, String why, StepKey subject) {
    return new Obstacle(
        kind,
        what,
        "",
        why,
        Extent.KNOWN,
        OptionalDouble.empty(),
        Optional.empty(),
        Optional.of(subject),
        List.of());
  }

  private static String said(String condition, String possible, Extent extent) throws IOException {
    return said(Kind.NUMBER, condition, possible, extent);
  }

  private static String said(Kind kind, String condition, String possible, Extent extent)
      throws IOException {
    return sentences()
        .obstacle(
            new Obstacle(
                kind,
                condition,
                "",
                possible,
                extent,
                OptionalDouble.empty(),
                Optional.empty(),
                Optional.empty(),
                List.of()));
  }

  private static ObstacleSentences sentences() throws IOException {
    Home home = home();
    return new ObstacleSentences(home, new PretendHouse(home).knowledge.snapshot());
  }

  private static Home home() throws IOException {
    try (InputStream turtle = ObstacleSentencesTest.class.getResourceAsStream("/bob.ttl")) {
      return new HomeLoader()
          .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }
}
