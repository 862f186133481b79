package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.language.Language;
import org.maestro.language.Understanding;
import org.maestro.language.reference.Discourse;
import org.maestro.language.reference.Situation;
import org.maestro.language.wording.AnswerWords;
import org.maestro.language.wording.GoalWords;
import org.maestro.ontology.home.Home;
import org.maestro.sl.Facts;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Truth;

/** German is a second data file: in Bob's home it means what English does. */
class GermanTest {
  private static final int MINUTE_OF_DAY = 18 * 60 + 5;

  private final Home home = Shipped.home("bob");
  private final Facts facts = SceneFacts.of(home, Optional.of(Shipped.scene("bob-cup-in-a", home)));
  private final Language german = Language.of(home, "de");
  private final Language english = Language.of(home, "en");

  /**
   * A line of the list: what is said by whom in which room after what, what it means or what is
   * said then, and in English what means the same, after what.
   */
  private record Line(
      String said, String before, String expected, String english, String englishBefore) {
    static Line of(String written) {
      String[] columns = written.split("\t", -1);
      return new Line(columns[0], columns[1], columns[2], columns[3], columns[4]);
    }

    boolean isMeant() {
      return expected.startsWith("(");
    }
  }

  private static List<Line> lines() {
    return SpokenEvening.text(GermanTest.class, "german.tsv")
        .lines()
        .filter(line -> !line.startsWith("#"))
        .map(Line::of)
        .toList();
  }

  private Situation situation() {
    return new Situation(
        home,
        facts,
        Optional.of("Bob"),
        Optional.of("zone-a"),
        Optional.of("rose"),
        OptionalInt.of(MINUTE_OF_DAY),
        Discourse.NONE);
  }

  private Understanding understood(Language language, String said, String before) {
    Situation situation = situation();
    if (!before.isEmpty()) {
      situation =
          situation.after(language.understand(before, situation).discourse(situation.discourse()));
    }
    return language.understand(said, situation);
  }

  private static String result(Understanding understood) {
    return understood
        .message()
        .map(SlPrinter::print)
        .or(() -> understood.question().map(text -> "- " + text))
        .or(() -> understood.reply().map(text -> "- " + text))
        .orElse("");
  }

  @Test
  void eachUtteranceMeansWhatStandsBesideIt() {
    List<String> expected = new ArrayList<>();
    List<String> results = new ArrayList<>();
    for (Line line : lines()) {
      expected.add(line.said() + " => " + line.expected());
      results.add(line.said() + " => " + result(understood(german, line.said(), line.before())));
    }

    assertThat(expected).hasSizeGreaterThan(60);
    assertThat(results).containsExactlyElementsOf(expected);
  }

  @Test
  void itMeansWhatIsMeantInEnglish() {
    List<String> meant = new ArrayList<>();
    List<String> meantInEnglish = new ArrayList<>();
    for (Line line : lines()) {
      if (line.isMeant() && !line.english().isEmpty()) {
        meant.add(line.said() + " => " + line.expected());
        meantInEnglish.add(
            line.said()
                + " => "
                + result(understood(english, line.english(), line.englishBefore())));
      }
    }

    assertThat(meant).hasSizeGreaterThan(60);
    assertThat(meantInEnglish).containsExactlyElementsOf(meant);
  }

  /** A word that nobody knows, in whichever place, is never passed over. */
  @Test
  void anUnknownWordNeverWidensWhatIsMeant() {
    List<String> wrong = new ArrayList<>();
    for (Line line : lines()) {
      List<String> words = List.of(line.said().split(" "));
      for (int at = 0; line.isMeant() && at <= words.size(); at++) {
        List<String> disturbed = new ArrayList<>(words);
        disturbed.add(at, "zqxwvk");
        Understanding understood = understood(german, String.join(" ", disturbed), line.before());
        // What is corrected after it, is corrected.
        boolean isRepaired = line.said().matches(".*(nein|Quatsch|ich meine|Mach, mach).*");
        if (understood.message().isPresent() && !isRepaired) {
          wrong.add(String.join(" ", disturbed) + " => " + result(understood));
        }
      }
    }

    assertThat(wrong).isEmpty();
  }

  @Test
  void whatIsKnownIsSaidInGerman() {
    AnswerWords words = new AnswerWords(home, german.grammar());

    assertThat(words.of(List.of(found(Truth.TRUE, Map.of("where", "zone-a"), 1))))
        .isEqualTo("Raum A.");
    assertThat(
            words.of(
                List.of(
                    found(Truth.TRUE, Map.of("x", "Cup"), 1),
                    found(Truth.TRUE, Map.of("x", "Bob"), 1))))
        .isEqualTo("Die Tasse und Bob.");
    assertThat(words.of(List.of(found(Truth.TRUE, Map.of("value", "20.456"), 1))))
        .isEqualTo("20,46.");
    assertThat(words.of(List.of(found(Truth.FALSE, Map.of(), 3700))))
        .isEqualTo("Nein. Das war vor einer Stunde.");
    assertThat(words.of(List.of(found(Truth.TRUE, Map.of(), 600))))
        .isEqualTo("Ja. Das war vor zehn Minuten.");
    assertThat(words.of(List.of())).isEqualTo("Das weiß ich nicht.");
    assertThat(words.counted(List.of(found(Truth.TRUE, Map.of("x", "Cup"), 1)), true))
        .isEqualTo("Eins.");
    assertThat(words.counted(List.of(), false)).isEqualTo("Null, von denen ich weiß.");
  }

  private static AnswerWords.Found found(Truth truth, Map<String, String> binding, double age) {
    return new AnswerWords.Found(truth, binding, OptionalDouble.of(age));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Waits: rose is held by G2. | Es muss warten: Rose wird gerade für etwas anderes gebraucht.",
        "lamp-a1 is needed and not there (its connection is gone). It would do if lamp-a1 were there (its connection is gone). | Lampe A1 wird gebraucht und ist nicht da (die Verbindung ist weg). Es ginge, wenn das so wäre: Lampe A1 ist da (die Verbindung ist weg).",
        "It is needed that Cup is in zone-a, so that rose picks up Cup, and Cup is in zone-b. | Nötig ist: die Tasse ist in Raum A; so aber ist es: die Tasse ist in Raum B. Erst dann ginge: Rose nimmt die Tasse.",
        "The mass of Cup has to be at most the payload of rose (0.5 kg), so that rose picks up Cup, and it is 0.9 kg. | Die Masse von der Tasse darf höchstens die Tragkraft von Rose (0,5 kg) sein; es ist 0,9 kg. Erst dann ginge: Rose nimmt die Tasse.",
        "lamp-a1 agreed to adjustLight and did not report within 3 s | Lampe A1 hat zugesagt (Licht einstellen) und sich in 3 Sekunden nicht gemeldet.",
        "Its deadline has passed while running (lamp-a1 is lost (it gives no answer)). | Die Frist ist vorbei, während es im Gang war (Lampe A1 ist nicht mehr zu erreichen (keine Antwort)).",
        "That failed: rose says: Cannot drive to zone-b: there is no free way: Cup stands in it. | Das ging nicht: Rose sagt: Ich komme nicht hin (Raum B): kein Weg ist frei: Im Weg steht die Tasse.",
        "rose cannot see Cup | Es gilt nicht „Rose sieht die Tasse“.",
      })
  void reasonsAreSaidInGerman(String report, String said) {
    GoalWords words = new GoalWords(home, german.grammar(), Optional.empty());

    assertThat(words.report(report)).isEqualTo(said);
  }

  @Test
  void whatNoRuleSaysIsQuotedInEnglish() {
    GoalWords words = new GoalWords(home, german.grammar(), Optional.empty());

    assertThat(words.report("The bulb of lamp-a1 has burst. No agent can bring it about."))
        .isEqualTo("„The bulb of lamp-a1 has burst“ (auf Englisch). Niemand kann das bewirken.");
    assertThat(words.report("That failed: lamp-a1 says: my bulb has burst."))
        .isEqualTo("Das ging nicht: Lampe A1 sagt: „my bulb has burst“ (auf Englisch).");
    assertThat(words.report("x, ".repeat(200) + "and (so on: " + "y; ".repeat(100)))
        .contains("(auf Englisch)");
  }

  @Test
  void theCommandIsAskedInALanguage() {
    assertThat(
            Printed.by(
                "understand",
                "Bob will seine Tasse",
                "--home",
                "bob",
                "--as",
                "Bob",
                "--in",
                "zone-a",
                "--language",
                "de"))
        .contains("(initCNP (:goal (nextTo Cup Bob)))");
    assertThat(Printed.by("words", "bob", "--language", "de")).contains("tasse").contains("lampen");
  }
}
