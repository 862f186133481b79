package org.maestro.language.grammar;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.language.Language;

/** Words change their form as a grammar says. */
class InflectionTest {
  private static Inflection of(String... lines) {
    return GrammarReader.read("language xx\n" + String.join("\n", lines), "xx.grammar")
        .inflection();
  }

  @Test
  void theFirstEndingThatFitsCounts() {
    Inflection inflection = of("ending many o$ i", "ending many $ s");

    assertThat(inflection.of("gato", "many")).isEqualTo("gati");
    assertThat(inflection.of("gat", "many")).isEqualTo("gats");
  }

  @Test
  void oneWordMayBeAnException() {
    Inflection inflection = of("ending many $ s", "irregular many = ox oxen, ewe ewe");

    assertThat(inflection.of("ox", "many")).isEqualTo("oxen");
    assertThat(inflection.of("ewe", "many")).isEqualTo("ewe");
    assertThat(inflection.of("box", "many")).isEqualTo("boxs");
  }

  @Test
  void anEndingMayTakeLettersAway() {
    assertThat(of("ending short en$").of("oxen", "short")).isEqualTo("ox");
  }

  @Test
  void aWordOfWhichNothingIsSaidStaysAsItIs() {
    Inflection inflection = of("ending many o$ i");

    assertThat(inflection.of("gat", "many")).isEqualTo("gat");
    assertThat(inflection.of("gato", "few")).isEqualTo("gato");
  }

  @Test
  void allFormsAreNamedOnce() {
    assertThat(
            of("ending many o$ i", "irregular many = ox oxen", "irregular past = go went").forms())
        .containsExactly("many", "past");
  }

  @ParameterizedTest
  @CsvSource({
    "plural, lamp, lamps",
    "plural, story, stories",
    "plural, day, days",
    "plural, switch, switches",
    "plural, shelf, shelves",
    "third, go, goes",
    "third, carry, carries",
    "third, play, plays",
    "third, be, is",
    "ing, close, closing",
    "ing, see, seeing",
    "ing, lie, lying",
    "ing, dim, dimming",
    "ing, clean, cleaning",
    "ing, open, opening",
    "past, dim, dimmed",
    "past, close, closed",
    "past, carry, carried",
    "past, take, took",
    "done, take, taken",
    "done, lock, locked",
  })
  void englishIsSpelledAsItIs(String form, String word, String expected) throws IOException {
    try (InputStream stream = Language.class.getResourceAsStream("en.grammar")) {
      String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
      assertThat(GrammarReader.read(text, "en.grammar").inflection().of(word, form))
          .isEqualTo(expected);
    }
  }
}
