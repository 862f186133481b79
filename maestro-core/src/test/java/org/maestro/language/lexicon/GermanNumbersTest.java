package org.maestro.language.lexicon;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.language.Language;
import org.maestro.language.chart.WordEntries;
import org.maestro.language.grammar.GrammarReader;

/** Numbers that are written as one word, the ones before the tens. */
class GermanNumbersTest {
  private static Lexicon lexicon;

  @BeforeAll
  static void read() throws IOException {
    try (InputStream stream = Language.class.getResourceAsStream("de.grammar")) {
      String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
      lexicon = new Lexicon(Map.of(), GrammarReader.read(text, "de.grammar"), form -> true);
    }
  }

  private static List<String> values(String text) {
    List<String> words = List.of(text.split(" "));
    return lexicon.endingWith(words).stream()
        .filter(entry -> entry.category().equals(Lexicon.NUMBER) && entry.words() == words.size())
        .map(WordEntries.Entry::meaning)
        .map(Object::toString)
        .toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "null | 0",
        "eins | 1",
        "zwölf | 12",
        "sechzehn | 16",
        "einundzwanzig | 21",
        "siebenunddreißig | 37",
        "hundert | 100",
        "hundertfünf | 105",
        "zweihundert | 200",
        "zweihundertzehn | 210",
        "dreihundertfünfundvierzig | 345",
        "tausend | 1000",
        "zweitausendfünfhundert | 2500",
        "einhundertfünfzigtausend | 150000",
        "21,5 | 21.5",
        "einundzwanzig komma fünf | 21.5",
        "null komma null fünf | 0.05",
        "eins komma fünfundsiebzig | 1.75",
        "minus zwei | -2",
        "minus einundzwanzig komma fünf | -21.5",
        "zweieinhalb | 2.5",
        "einundzwanzigeinhalb | 21.5",
        "zwei einhalb | 2.5",
        "anderthalb | 1.5",
      })
  void aNumberIsWhatItsPartsAre(String word, String value) {
    assertThat(values(word)).containsExactly(value);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "zwanzigeins",
        "fünfsechs",
        "zehnundfünf",
        "und",
        "undzwanzig",
        "einund",
        "einundzehn",
        "einundzwanzigste",
        "lampe",
        "achtlampe",
        "einhalb",
        "lampeeinhalb",
        "zwei komma anderthalb",
      })
  void whatIsNotOneNumberIsNone(String word) {
    assertThat(values(word)).isEmpty();
    assertThat(lexicon.knows(word)).isFalse();
  }
}
