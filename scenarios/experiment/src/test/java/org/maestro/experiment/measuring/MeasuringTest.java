package org.maestro.experiment.measuring;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
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
