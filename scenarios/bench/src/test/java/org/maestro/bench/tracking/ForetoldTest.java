package org.maestro.bench.tracking;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** What is told is judged by what was so. */
class ForetoldTest {
  private final Foretold foretold = new Foretold();

  private void at(int second, String zone, String heading) {
    foretold.note(
        "Dave",
        zone,
        !zone.equals("hallway"),
        Optional.of(heading).filter(word -> !word.isEmpty()),
        0.8,
        Duration.ofSeconds(second));
  }

  @Test
  void whoComesThereInTimeWasForetoldRightly() {
    at(0, "garden", "");
    at(1, "hallway", "livingroom");
    at(4, "hallway", "livingroom");
    at(6, "livingroom", "");

    assertThat(foretold.told()).isEqualTo(1);
    assertThat(foretold.leadSeconds()).containsExactly(5.0);
    assertThat(foretold.moves()).isEqualTo(1);
    assertThat(foretold.calibration().brier()).isCloseTo(0.04, within(1e-9));
  }

  @Test
  void whoGoesElsewhereOrTooLateWasNot() {
    at(0, "hallway", "livingroom");
    at(5, "kitchen", "");
    at(70, "livingroom", "");

    assertThat(foretold.told()).isEqualTo(1);
    assertThat(foretold.leadSeconds()).isEmpty();
    assertThat(foretold.calibration().brier()).isCloseTo(0.64, within(1e-9));
  }

  @Test
  void whatIsOpenAtTheEndOfAnEveningDoesNotCount() {
    at(0, "hallway", "livingroom");
    foretold.begin();

    assertThat(foretold.told()).isZero();
  }

  @Test
  void whatIsAsSureAsItIsOftenSoIsCalibrated() {
    Calibration calibration = new Calibration();
    for (int i = 0; i < 100; i++) {
      calibration.add(0.75, i < 75);
    }

    assertThat(calibration.error()).isCloseTo(0, within(1e-9));
    assertThat(calibration.brier()).isCloseTo(0.1875, within(1e-9));
    assertThat(calibration.lines())
        .containsExactly("told with 0.70 to 0.80, 0.750 in the mean: so in 0.750 of 100 cases");
  }
}
