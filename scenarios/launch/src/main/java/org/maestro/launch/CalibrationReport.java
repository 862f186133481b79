package org.maestro.launch;

import com.fasterxml.jackson.databind.node.ArrayNode;
import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.maestro.console.documents.JsonMembers;
import org.maestro.sim.calibration.Calibrated;
import org.maestro.sim.calibration.LightLevel;
import org.maestro.sim.calibration.LogisticFit;

/** What the calibration of a camera found, for people and for programs. */
record CalibrationReport(Calibrated calibrated) {
  private static final double EXACT_LUX = 10;

  /** For people. */
  void print(PrintWriter out) {
    out.printf(
        Locale.ROOT,
        "%s and %s, at %d places %.1f to %.1f m from the lens:%n%n",
        calibrated.camera(),
        calibrated.thing(),
        calibrated.places(),
        calibrated.nearest(),
        calibrated.farthest());
    if (!calibrated.isFound()) {
      out.println(
          "In no light do its pictures show it: it is too small or far, or has no colour of its own.");
      return;
    }
    new Table(List.of("light (lux)", "frames that show it (%)", "by the model (%)"), rows())
        .print(out);
    LogisticFit dark = calibrated.inTheDark();
    LogisticFit bright = calibrated.overLit();
    out.printf(
        Locale.ROOT,
        "%nHalf of the frames show it in %.1f lux, and in %.0f lux again; %s.%n",
        dark.halfLux(),
        bright.halfLux(),
        nearlyAll());
    out.printf(
        Locale.ROOT,
        "The model errs by %.1f %% in the mean and by %.0f %% at most.%n",
        100 * calibrated.meanError(),
        100 * calibrated.greatestError());
    out.printf(
        Locale.ROOT,
        "It is seen %.1f cm from where it is, in the mean. Where it is not, %d of %d frames show it.%n",
        100 * calibrated.offset(),
        calibrated.whereNothingIs(),
        calibrated.framesWithoutIt());
    out.println();
    out.println("The model comes nearest with:");
    calibrated
        .settings()
        .forEach((name, value) -> out.printf(Locale.ROOT, "  --set %s=%.4g%n", name, value));
  }

  private String nearlyAll() {
    OptionalDouble least = calibrated.leastLux();
    OptionalDouble most = calibrated.greatestLux();
    return least.isPresent() && most.isPresent()
        ? String.format(
            Locale.ROOT,
            "nearly all did from %.1f to %.0f lux",
            least.getAsDouble(),
            most.getAsDouble())
        : "in no light nearly all did";
  }

  private List<List<String>> rows() {
    List<List<String>> rows = new ArrayList<>();
    calibrated.dark().forEach(level -> rows.add(row(level, calibrated.inTheDark())));
    // both begin, or end, with the same light
    calibrated.bright().stream()
        .skip(1)
        .forEach(level -> rows.add(row(level, calibrated.overLit())));
    return rows;
  }

  private static List<String> row(LightLevel level, LogisticFit fit) {
    return List.of(
        String.format(Locale.ROOT, level.lux() < EXACT_LUX ? "%.2f" : "%.0f", level.lux()),
        String.format(Locale.ROOT, "%.0f", 100 * level.rate()),
        String.format(Locale.ROOT, "%.0f", 100 * fit.rate(level.lux())));
  }

  /** For programs. */
  String document() {
    JsonMembers document =
        JsonMembers.empty()
            .text("camera", calibrated.camera())
            .text("thing", calibrated.thing())
            .number("places", OptionalInt.of(calibrated.places()))
            .number("nearest_m", OptionalDouble.of(calibrated.nearest()))
            .number("farthest_m", OptionalDouble.of(calibrated.farthest()));
    levels(document.node().putArray("dark"), calibrated.dark(), calibrated.inTheDark());
    levels(document.node().putArray("bright"), calibrated.bright(), calibrated.overLit());
    document
        .number("frames_without_it", OptionalInt.of(calibrated.framesWithoutIt()))
        .number("frames_that_show_it_then", OptionalInt.of(calibrated.whereNothingIs()))
        .number("offset_m", OptionalDouble.of(calibrated.offset()))
        .number("mean_error", OptionalDouble.of(calibrated.meanError()))
        .number("greatest_error", OptionalDouble.of(calibrated.greatestError()));
    JsonMembers settings = document.in("settings");
    if (calibrated.isFound()) {
      calibrated
          .settings()
          .forEach((name, value) -> settings.number(name, OptionalDouble.of(value)));
    }
    return document.toString();
  }

  private static void levels(ArrayNode array, List<LightLevel> levels, LogisticFit fit) {
    for (LightLevel level : levels) {
      JsonMembers.in(array)
          .number("lux", OptionalDouble.of(level.lux()))
          .number("frames", OptionalInt.of(level.frames()))
          .number("shown", OptionalInt.of(level.shown()))
          .number("elsewhere", OptionalInt.of(level.elsewhere()))
          .number("by_the_model", OptionalDouble.of(fit.rate(level.lux())));
    }
  }
}
