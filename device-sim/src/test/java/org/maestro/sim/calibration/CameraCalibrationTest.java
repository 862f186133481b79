package org.maestro.sim.calibration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.sim.Homes;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;

class CameraCalibrationTest {
  private static final Scene EMPTY = new Scene("empty", Map.of());

  private static Calibrated calibrated(String thing, PhysicalParameters parameters) {
    try (CameraCalibration calibration =
        new CameraCalibration(Homes.home("arena"), EMPTY, "cam-2", thing, parameters, 1)) {
      return calibration.carriedOut(1);
    }
  }

  @Test
  void theFastModelIsFittedToThePictures() {
    Calibrated calibrated = calibrated("RedObject1", PhysicalParameters.standard());

    assertThat(calibrated.isFound()).isTrue();
    assertThat(calibrated.meanError()).isLessThan(0.1);
    assertThat(calibrated.offset()).isLessThan(0.05);
    assertThat(calibrated.whereNothingIs()).isZero();
    Map<String, String> settings = new TreeMap<>();
    calibrated.settings().forEach((name, value) -> settings.put(name, String.valueOf(value)));
    PhysicalParameters fitted = PhysicalParameters.standard().with(settings);
    for (LightLevel level : calibrated.dark()) {
      assertThat(fitted.camera().brightness(level.lux()))
          .isCloseTo(level.rate(), within(calibrated.greatestError() + 1e-6));
    }
    for (LightLevel level : calibrated.bright()) {
      assertThat(1 - fitted.camera().glare(level.lux()))
          .isCloseTo(level.rate(), within(calibrated.greatestError() + 1e-6));
    }
  }

  /** A sensor that gathers less light needs more of it: the threshold follows from the sensor. */
  @Test
  void aWorseSensorNeedsMoreLight() {
    Calibrated usual = calibrated("GreenObject", PhysicalParameters.standard());
    Calibrated worse =
        calibrated(
            "GreenObject",
            PhysicalParameters.standard()
                .with(Map.of("world.image.shotNoise", "0.05", "world.image.readNoise", "0.01")));

    assertThat(worse.inTheDark().halfLux()).isGreaterThan(3 * usual.inTheDark().halfLux());
  }

  @Test
  void aLogisticFunctionIsFoundAgain() {
    for (double[] truth : new double[][] {{69, 0.75}, {1.5, 0.2}, {200, 60}}) {
      LogisticFit function = new LogisticFit(truth[0], truth[1]);
      List<LightLevel> levels = new ArrayList<>();
      for (double lux = truth[0] / 4; lux < 4 * truth[0]; lux *= 1.02) {
        levels.add(new LightLevel(lux, 10_000, (int) Math.round(10_000 * function.rate(lux)), 0));
      }
      LogisticFit fit = LogisticFit.of(levels, true);
      assertThat(fit.halfLux()).isCloseTo(truth[0], within(0.01 * truth[0]));
      assertThat(fit.greatestError(levels)).isLessThan(0.03);
    }
  }

  @Test
  void whatHasNoColourIsRefused() {
    Home home = Homes.home("arena");
    PhysicalParameters parameters = PhysicalParameters.standard();

    assertThat(CameraCalibration.cameras(home)).containsExactly("cam-1", "cam-2", "cam-3");
    assertThat(CameraCalibration.things(home))
        .containsExactly("GreenObject", "RedObject1", "RedObject2");
    assertThatThrownBy(
            () -> new CameraCalibration(home, EMPTY, "lamp-1", "GreenObject", parameters, 1))
        .isInstanceOf(SimulationException.class)
        .hasMessageContaining("lamp-1 is no camera");
  }
}
