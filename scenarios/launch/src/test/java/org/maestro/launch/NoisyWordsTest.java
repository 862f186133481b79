package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.bench.words.NoiseBench;
import org.maestro.bench.words.SaidLine;
import org.maestro.language.Language;
import org.maestro.language.reference.Situation;
import org.maestro.sl.SlPrinter;

/** Of words that are lost, exchanged or misheard nothing is made that nobody said (A64). */
class NoisyWordsTest {
  private static final double WRONG_AT_MOST = 0.02;

  private final SpokenEvening evening = new SpokenEvening();
  private final Language language = Language.of(evening.home(), "en");
  private final List<SaidLine> lines =
      SpokenEvening.text(UnderstandCommandTest.class, "evening.tsv")
          .lines()
          .filter(line -> !line.startsWith("#"))
          .map(SaidLine::of)
          .toList();

  @Test
  void atATenthOfTheWordsHardlyAnythingElseIsDone() {
    NoiseBench.Rates rates = rates(15, 10, 20261);

    assertThat(rates.wrong())
        .as("%s", rates)
        .isLessThanOrEqualTo((int) (WRONG_AT_MOST * rates.said()));
    // So that noise is noise, and does not make all of it be asked back.
    assertThat(rates.noisy()).as("%s", rates).isGreaterThan(rates.said() / 3);
    assertThat(rates.right()).as("%s", rates).isGreaterThan(rates.said() / 2);
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  @Tag("full")
  void whateverTheNoiseHardlyAnythingElseIsDone(long seed) {
    NoiseBench.Rates rates = rates(100, 10, seed);

    assertThat(rates.wrong())
        .as("%s", rates)
        .isLessThanOrEqualTo((int) (WRONG_AT_MOST * rates.said()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "turn on the kitchen light at 37 pm",
        "turn on the kitchen light at 19 am",
        "add milk the to shopping list",
        "put bread my on shopping list",
        "tell Rose that I like the",
      })
  void whatIsNoTimeAndWhatDoesNotEndIsNotTakenForOne(String words) {
    Situation situation = evening.situation(evening.home(), SpokenEvening.lines().get(0));

    assertThat(language.understand(words, situation).message()).isEmpty();
  }

  @ParameterizedTest
  @ValueSource(strings = {"number", "percent", "span", "plus", "quantity", "text", "np"})
  void aTextMayBeOfAnyWord(String word) {
    Situation situation = evening.situation(evening.home(), SpokenEvening.lines().get(0));

    assertThat(language.understand("add " + word + " to the shopping list", situation).message())
        .map(SlPrinter::print)
        .contains(
            "(perform (:script addToList) (:list shopping-list) (:what \"%s\"))".formatted(word));
  }

  private NoiseBench.Rates rates(int times, int share, long seed) {
    return new NoiseBench(
            language,
            line ->
                evening.situation(
                    evening.home(),
                    new SpokenEvening.Line(
                        line.words(),
                        line.speaker().orElseThrow(),
                        line.room().orElseThrow(),
                        line.before())),
            times,
            seed,
            told -> {})
        .rates(lines, share);
  }
}
