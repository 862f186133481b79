package org.maestro.language.wording;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.language.Language;
import org.maestro.language.grammar.GrammarReader;

/** Names stand in sentences in the form that these want, by the article that they have. */
class PhrasesTest {
  private static Phrases german;
  private static Phrases english;

  @BeforeAll
  static void read() throws IOException {
    german = phrases("de.grammar");
    english = phrases("en.grammar");
  }

  private static Phrases phrases(String file) throws IOException {
    try (InputStream stream = Language.class.getResourceAsStream(file)) {
      return new Phrases(
          GrammarReader.read(new String(stream.readAllBytes(), StandardCharsets.UTF_8), file));
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "die Lampe | accusative | die Lampe",
        "der Tisch | accusative | den Tisch",
        "der große rote Becher | accusative | den großen roten Becher",
        "das kleine Glas | accusative | das kleine Glas",
        "die kleine Lampe | dative | der kleinen Lampe",
        "der Tisch | dative | dem Tisch",
        "das kleine Glas | dative | dem kleinen Glas",
        "die Tür zwischen A und B | dative | der Tür zwischen A und B",
        "Lampe A1 | dative | Lampe A1",
        "der Becher | which | welchen Becher",
        "die Lampe | which | welche Lampe",
        "das Glas | which | welches Glas",
        "Sache | which | was von der Art Sache",
        "der rot Becher | none | keinen roten Becher",
        "die rot Tasse | none | keine rote Tasse",
        "das rot Glas | none | kein rotes Glas",
        "die Tasse dort | none | keine Tasse dort",
        "Raum X | none | nichts namens Raum X",
      })
  void aNameTakesTheFormOfItsArticle(String name, String form, String expected) {
    assertThat(german.filled("{name " + form + "}", Map.of("name", name))).isEqualTo(expected);
  }

  @Test
  void eachOfSeveralNamesTakesTheForm() {
    assertThat(
            german.of(
                "which",
                Map.of(
                    "kind", "der Becher", "first", "der rote Becher, der alte", "last", "Topf A")))
        .isEqualTo("welchen Becher meinst du, den roten Becher, den alten oder Topf A?");
  }

  @Test
  void aLanguageWithoutFormsLeavesNamesAsTheyAre() {
    assertThat(english.of("which", Map.of("kind", "lamp", "first", "the lamp", "last", "lamp A1")))
        .isEqualTo("Which lamp, the lamp or lamp A1?");
  }

  @Test
  void aPlaceThatNothingIsSaidOfStays() {
    assertThat(english.filled("Where is {object}?", Map.of())).isEqualTo("Where is {object}?");
  }
}
