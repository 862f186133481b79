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

/** Numbers are entries of each lexicon, in words and in figures. */
class NumberWordsTest {
  private static Lexicon lexicon;

  @BeforeAll
  static void read() throws IOException {
    try (InputStream stream = Language.class.getResourceAsStream("en.grammar")) {
      String text = new String(stream.readAllBytes(), StandardCharsets.UTF_8);
      lexicon = new Lexicon(Map.of(), GrammarReader.read(text, "en.grammar"), form -> true);
    }
  }

  /** What all of the words are, as one number. */
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
        "zero | 0",
        "twelve | 12",
        "twenty five | 25",
        "twenty-five | 25",
        "two hundred | 200",
        "two hundred five | 205",
        "two hundred and ten | 210",
        "one hundred twenty five | 125",
        "two thousand five hundred | 2500",
        "two hundred thousand | 200000",
        "one hundred fifty thousand | 150000",
        "12 | 12",
        "-3 | -3",
        "0.5 | 0.5",
        "0,5 | 0.5",
        "a hundred | 100",
        "a hundred and ten | 110",
        "a thousand | 1000",
        "twenty one point five | 21.5",
        "zero point zero five | 0.05",
        "zero point oh five | 0.05",
        "two point five o | 2.5",
        "three point nought nought one | 3.001",
        "two hundred and ten point seven five | 210.75",
        "three point fifteen | 3.15",
        "3 point 5 | 3.5",
        "3 point 05 | 3.05",
        "minus two | -2",
        "minus twenty one point five | -21.5",
        "twenty one and a half | 21.5",
        "minus two and a half | -2.5",
        "2 and a half | 2.5",
      })
  void aNumberIsWhatItsWordsAre(String words, String value) {
    assertThat(values(words)).containsExactly(value);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "five twenty",
        "five six",
        "twenty fifteen",
        "fifteen five",
        "twenty zero",
        "hundred",
        "five hundred three hundred",
        "two hundred and",
        "and ten",
        "ten and five",
        "two hundred hundred",
        "1e9",
        "1234567890123456",
        "12:30",
        "lamp",
        "five lamp",
        "a",
        "a five",
        "a hundred hundred",
        "minus",
        "minus minus two",
        "minus -2",
        "point five",
        "five point",
        "five point lamp",
        "oh",
        "oh point five",
        "oh five",
        "five point five point five",
        "0.5 point 5",
        "five point hundred",
        "and a half",
        "0.5 and a half",
        "-2 and a half",
        "3 point 1.5",
      })
  void whatIsNotOneNumberIsNone(String words) {
    assertThat(values(words)).isEmpty();
  }

  /** Nothing that was said so far is taken back, and it is waited for the rest. */
  @ParameterizedTest
  @CsvSource({
    "minus, true",
    "twenty one point, true",
    "minus five point, true",
    "two and, true",
    "two and a, true",
    "a, true",
    "point, false",
    "lamp point, false",
    "and a, false",
    "lamp, false"
  })
  void moreMayBelongToANumber(String words, boolean expected) {
    assertThat(lexicon.isBeginning(List.of(words.split(" ")), Lexicon.NUMBER::equals))
        .isEqualTo(expected);
    assertThat(lexicon.isBeginning(List.of(words.split(" ")), category -> false)).isFalse();
  }

  @ParameterizedTest
  @CsvSource({
    "10:30, true",
    "7:05, true",
    "23:59, true",
    "24:00, false",
    "10:60, false",
    "10, false"
  })
  void aTimeOfDayIsWrittenInFigures(String word, boolean expected) {
    assertThat(
            lexicon.endingWith(List.of(word)).stream()
                .anyMatch(entry -> entry.category().equals(Lexicon.TIME)))
        .isEqualTo(expected);
  }

  @ParameterizedTest
  @CsvSource({"seven, true", "70, true", "minus, true", "point, true", "lamp, false"})
  void aNumberIsAKnownWord(String word, boolean expected) {
    assertThat(lexicon.knows(word)).isEqualTo(expected);
  }
}
