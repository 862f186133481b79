package org.maestro.experiment.measuring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Against values reckoned by hand, and the table that RFC 4180 describes. */
class MeasuringTest {
  @TempDir private Path directory;

  @Test
  void aSpreadHasTheDeviationOfASample() {
    Spread spread = Spread.of(2, 4, 6);

    assertThat(spread.mean()).isEqualTo(4);
    assertThat(spread.deviation()).isEqualTo(2);
    assertThat(spread.least()).isEqualTo(2);
    assertThat(spread.greatest()).isEqualTo(6);
    assertThat(Spread.of(3).deviation()).isZero();
    assertThat(Spread.of().mean()).isNaN();
  }

  @Test
  void aShareHasWilsonsInterval() {
    Share share = new Share(18, 20);

    assertThat(share.value()).isEqualTo(0.9);
    assertThat(share.least()).isCloseTo(0.699, within(0.001));
    assertThat(share.greatest()).isCloseTo(0.972, within(0.001));
    assertThat(share.text()).isEqualTo("18 of 20 (95 % interval 70 to 97 %)");
  }

  @Test
  void aMeanHasStudentsInterval() {
    Interval three = Interval.ofMean(Spread.of(2, 4, 6));
    assertThat(three.greatest() - 4).isCloseTo(4.303 * 2 / Math.sqrt(3), within(0.001));
    assertThat(4 - three.least()).isCloseTo(three.greatest() - 4, within(1e-9));

    double[] ten = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
    Spread spread = Spread.of(ten);
    double half = Interval.ofMean(spread).greatest() - spread.mean();
    assertThat(half / (spread.deviation() / Math.sqrt(10))).isCloseTo(2.262, within(0.01));
    assertThat(Interval.ofMean(Spread.of(3)).least()).isNaN();
    assertThat(three.overlaps(Interval.ofMean(spread))).isTrue();
    assertThat(new Interval(1, 2).overlaps(new Interval(3, 4))).isFalse();
  }

  /** The example with which Newcombe (1998) compares his methods. */
  @Test
  void twoSharesDifferByNewcombesInterval() {
    Difference difference = Difference.ofShares(new Share(48, 80), new Share(56, 70));

    assertThat(difference.value()).isCloseTo(0.2, within(1e-9));
    assertThat(difference.interval().least()).isCloseTo(0.0524, within(1e-4));
    assertThat(difference.interval().greatest()).isCloseTo(0.3339, within(1e-4));
    assertThat(difference.isShown(100, 0)).isTrue();
    assertThat(difference.text(100, 0)).isEqualTo("+20 (+5 to +33)");
    assertThat(Difference.ofShares(new Share(0, 0), new Share(1, 1)).isShown(100, 0)).isFalse();
  }

  @Test
  void whatBelongsTogetherInPairsDiffersByStudentsInterval() {
    Difference difference = Difference.ofPairs(List.of(1.0, 2.0, 3.0), List.of(3.0, 6.0, 9.0));

    assertThat(difference.value()).isEqualTo(4);
    assertThat(difference.interval()).isEqualTo(Interval.ofMean(Spread.of(2, 4, 6)));
    assertThat(difference.isShown(1, 1)).as("4 +- 5").isFalse();
    assertThat(Difference.ofPairs(List.of(1.0), List.of(2.0)).isShown(1, 1))
        .as("one pair")
        .isFalse();
    assertThat(Difference.ofPairs(List.of(1.0), List.of(2.0)).text(1, 1)).isEqualTo("+1.0");
    assertThat(Difference.ofPairs(List.of(), List.of()).text(1, 1)).isEmpty();
  }

  @Test
  void whatIsTooSmallToBePrintedIsNotShown() {
    Difference difference =
        Difference.ofPairs(List.of(9.40, 9.41, 9.42), List.of(9.42, 9.43, 9.441));

    assertThat(difference.text(1, 1)).isEqualTo("0.0 (0.0 to 0.0)");
    assertThat(difference.isShown(1, 1)).isFalse();
    assertThat(difference.isShown(1, 2)).isTrue();
  }

  @Test
  void aTableQuotesWhatNeedsIt() throws IOException {
    Table table = new Table("a", "b");
    table.add(1, "so, \"he\" said");
    table.add(0.12345, Double.NaN);
    Path file = directory.resolve("t.csv");
    table.write(file);

    assertThat(file).hasContent("a,b\n1,\"so, \"\"he\"\" said\"\n0.123,\n");
  }
}
