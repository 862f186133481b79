package org.maestro.experiment;

import java.util.List;
import java.util.Locale;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.LightChart;
import org.maestro.experiment.drawing.TimeChart;
import org.maestro.experiment.measuring.Table;
import org.maestro.ontology.home.Home;
import org.maestro.sim.calibration.Calibrated;
import org.maestro.sim.calibration.CameraCalibration;
import org.maestro.sim.calibration.LightLevel;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.parameters.PhysicalParameters;

/**
 * What the pictures of a camera show of a thing in which light, beside what runs reckon with.
 *
 * @param reckoned the chances by which runs without pictures go
 */
record PixelCurve(Calibrated seen, CameraData reckoned) {
  private static final int PLACES = 2;

  static PixelCurve measured(PhysicalParameters parameters, long seed) {
    Home home = Shipped.home("arena");
    try (CameraCalibration calibration =
        new CameraCalibration(
            home,
            Shipped.scene("arena-light", home),
            LightRun.CAMERA,
            LightRun.OBJECT,
            parameters,
            seed)) {
      return new PixelCurve(calibration.carriedOut(PLACES), parameters.camera());
    }
  }

  private List<LightLevel> levels() {
    return seen.levels().toList();
  }

  Table table() {
    Table table = new Table("lux", "frames", "shown", "elsewhere", "rate", "rate_reckoned");
    for (LightLevel level : levels()) {
      table.add(
          level.lux(),
          level.frames(),
          level.shown(),
          level.elsewhere(),
          level.rate(),
          reckoned.detectability(level.lux()));
    }
    return table;
  }

  Figure figure() {
    return Figure.of(
        "rate-pixels",
        "Share of frames that show the green object over the light upon it: found in pictures of the camera by colour and size, and as the runs above reckon with it, which puts the paper's threshold in. Neither was fitted to the other.",
        LightChart.draw(
            "What pictures show, and what runs reckon with",
            "frames that show the object (%)",
            new TimeChart.Series(
                "found in pictures",
                Ink.RED,
                levels().stream()
                    .map(level -> new double[] {level.lux(), 100 * level.rate()})
                    .toList()),
            new TimeChart.Series(
                "reckoned with",
                Ink.BLUE,
                levels().stream()
                    .map(
                        level ->
                            new double[] {level.lux(), 100 * reckoned.detectability(level.lux())})
                    .toList()),
            new TimeChart.Event(Illumination.THRESHOLD, "the paper: 72 lux")));
  }

  /** Light in which half of the frames show it; lux, not a number when none does. */
  double halfLux() {
    return seen.isFound() ? seen.inTheDark().halfLux() : Double.NaN;
  }

  /** For the page. */
  String range() {
    return seen.leastLux().isPresent()
        ? String.format(
            Locale.ROOT,
            "half of the frames in %.1f lux, nearly all from %.1f to %.0f lux",
            halfLux(),
            seen.leastLux().getAsDouble(),
            seen.greatestLux().orElseThrow())
        : "in no light do nearly all frames show it";
  }

  /** What follows for the paper's threshold. */
  String meaning() {
    return halfLux() < Illumination.THRESHOLD / 2
        ? "Found in pictures it is in far less light than in the paper: the grain of light and the noise of reading a sensor do not explain 72 lux. What else the paper's camera lost in the dark, such as colours that its own processing washes out, or brightness below which its program did not look, is not known and not simulated."
        : "From what light on it is found in pictures follows from the settings of this run, above all from the noise and the size of pictures.";
  }
}
