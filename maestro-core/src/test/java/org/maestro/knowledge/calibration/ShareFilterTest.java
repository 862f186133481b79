package org.maestro.knowledge.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ShareFilterTest {
  private static final double[] STATED = {80, 60};
  private static final double REST = 17;

  @Test
  void twoChangesTellHowMuchALampGives() {
    ShareFilter filter = new ShareFilter(STATED);
    filter.measured(0, new double[] {0, 0}, REST);
    filter.measured(3, new double[] {1, 0}, REST + 40);
    assertThat(filter.share(0)).isCloseTo(40, within(4.0));
    assertThat(filter.isOtherwise(0)).isFalse();

    filter.measured(30, new double[] {0, 0}, REST);

    assertThat(filter.share(0)).isCloseTo(40, within(4.0));
    assertThat(filter.isOtherwise(0)).isTrue();
    assertThat(filter.share(1)).isEqualTo(60);
    assertThat(filter.isOtherwise(1)).isFalse();
  }

  @Test
  void whatWasSetAtOnceIsToldApartAsSoonAsItIsSetAlone() {
    ShareFilter filter = new ShareFilter(STATED);
    filter.measured(0, new double[] {0, 0}, REST);
    filter.measured(3, new double[] {1, 1}, REST + 20 + 60);
    assertThat(filter.share(0) + filter.share(1)).isCloseTo(80, within(3.0));

    filter.measured(3, new double[] {0, 1}, REST + 60);

    assertThat(filter.share(0)).isCloseTo(20, within(6.0));
    assertThat(filter.isOtherwise(0)).isTrue();
    assertThat(filter.share(1)).isCloseTo(60, within(6.0));
    assertThat(filter.isOtherwise(1)).isFalse();
  }

  @Test
  void lightFromElsewhereIsNoLamps() {
    ShareFilter filter = new ShareFilter(STATED);
    filter.measured(0, new double[] {1, 0}, REST + 80);
    filter.measured(10, new double[] {1, 0}, REST + 80 + 300);
    filter.measured(10, new double[] {1, 0}, REST + 80 + 150);

    assertThat(filter.share(0)).isCloseTo(80, within(1.0));
    assertThat(filter.isOtherwise(0)).isFalse();
  }

  @Test
  void aLampThatWasReplacedIsLearntAnew() {
    ShareFilter filter = new ShareFilter(STATED);
    for (int n = 0; n < 20; n++) {
      filter.measured(5, new double[] {n % 2, 0}, REST + n % 2 * 30);
    }
    assertThat(filter.share(0)).isCloseTo(30, within(1.0));

    filter.measured(5, new double[] {0, 0}, REST);
    filter.measured(5, new double[] {1, 0}, REST + 80);

    assertThat(filter.share(0)).isCloseTo(80, within(3.0));
    assertThat(filter.isAsStated(0)).isTrue();
  }

  @Test
  void whatComesBesideIsNoLamps() {
    ShareFilter filter = new ShareFilter(STATED);
    filter.measured(0, new double[] {0, 0}, REST);
    filter.measured(3, new double[] {1, 0}, REST + 80);

    filter.forgetRest();
    filter.measured(3, new double[] {0, 0}, REST + 40);

    assertThat(filter.share(0)).isCloseTo(80, within(3.0));
  }

  @Test
  void whatStartsAnewIsAsStated() {
    ShareFilter filter = new ShareFilter(STATED);
    filter.measured(0, new double[] {0, 0}, REST);
    filter.measured(3, new double[] {1, 0}, REST + 40);

    filter.restart(0);

    assertThat(filter.share(0)).isEqualTo(80);
    assertThat(filter.isOtherwise(0)).isFalse();
  }

  /**
   * Lamps as stated, sensors with 1 % noise, light from outside that wanders: in a second by so
   * many lux.
   */
  @ParameterizedTest
  @CsvSource({"0, 0", "1, 0.001", "3, 0.01", "10, 0.1"})
  void chanceTeachesNothing(double wanderPerSecond, double mostOften) {
    int told = 0;
    for (int seed = 0; seed < 200; seed++) {
      Random random = new Random(seed);
      ShareFilter filter = new ShareFilter(STATED);
      double rest = 100 + 400 * random.nextDouble();
      for (int n = 0; n < 60; n++) {
        double seconds = 1 + random.nextInt(20);
        rest = Math.max(0, rest + wanderPerSecond * Math.sqrt(seconds) * random.nextGaussian());
        double[] levels = {random.nextInt(3) / 2.0, random.nextInt(3) / 2.0};
        double lux = rest + 80 * levels[0] + 60 * levels[1];
        filter.measured(seconds, levels, lux * (1 + 0.01 * random.nextGaussian()));
        told += filter.isOtherwise(0) || filter.isOtherwise(1) ? 1 : 0;
      }
    }
    assertThat(told / (200 * 60.0)).isLessThanOrEqualTo(mostOften);
  }

  /** At dawn lamps are dimmed as it gets lighter. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 1})
  void lightThatRisesMakesNoLampWeak(double luxPerSecond) {
    int told = 0;
    for (int seed = 0; seed < 100; seed++) {
      Random random = new Random(seed);
      ShareFilter filter = new ShareFilter(STATED);
      double rest = 50;
      for (int n = 0; n < 100; n++) {
        rest += 10 * luxPerSecond;
        double level = Math.max(0, Math.ceil((120 - rest) / 80 * 20) / 20);
        double lux = rest + 80 * level;
        filter.measured(10, new double[] {level, 0}, lux * (1 + 0.01 * random.nextGaussian()));
        told += filter.isOtherwise(0) ? 1 : 0;
      }
    }
    assertThat(told / 1e4).isLessThan(0.01);
  }

  /** Lamps that give what they give, whatever is stated. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.5, 0.8, 1.6})
  void aWeakOrStrongLampIsFoundOut(double strength) {
    for (int seed = 0; seed < 100; seed++) {
      Random random = new Random(seed);
      ShareFilter filter = new ShareFilter(STATED);
      for (int n = 0; n < 12; n++) {
        double[] levels = {random.nextInt(3) / 2.0, random.nextInt(3) / 2.0};
        double lux = 20 + strength * 80 * levels[0] + 60 * levels[1];
        filter.measured(5, levels, lux * (1 + 0.01 * random.nextGaussian()));
      }
      assertThat(filter.share(0)).isCloseTo(strength * 80, within(8.0));
      assertThat(filter.share(1)).isCloseTo(60, within(8.0));
    }
  }
}
