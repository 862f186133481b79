package org.maestro.experiment;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.maestro.experiment.measuring.Difference;

/**
 * A figure of each of the homes that are compared, and how much more of it each has than the first.
 *
 * @param what is measured
 * @param of the goal or zone of which it is; "" of the whole evening
 * @param values one of each home; NaN where there was nothing to measure
 * @param cells the same as people read it
 * @param differences of all but the first to the first; none where they say nothing
 */
record Measure(
    Kind what, String of, List<Double> values, List<String> cells, List<Difference> differences) {
  Measure {
    values = List.copyOf(values);
    cells = List.copyOf(cells);
    differences = List.copyOf(differences);
  }

  /** What is measured, with the words in which a difference is claimed. */
  enum Kind {
    ALL_REACHED("goals reached", "", 1, 0, "", ""),
    FALSELY_CLAIMED("claims what is not so", "", 1, 0, "", ""),
    REACHED("reached", "%", 100, 0, "reaches %s more often than", "reaches %s less often than"),
    TIME(
        "time, where it was reached",
        "s",
        1,
        1,
        "takes longer for %s than",
        "is sooner done with %s than"),
    EVENING("time of the evening", "s", 1, 1, "takes longer%s than", "is sooner done%s than"),
    ENERGY("energy", "Wh", 1, 2, "uses more energy%s than", "uses less energy%s than"),
    LIGHT(
        "light, mean of the evening",
        "lux",
        1,
        0,
        "has more light in %s than",
        "has less light in %s than");

    private final String label;
    private final String unit;
    private final double factor;
    private final int places;
    private final String more;
    private final String less;

    Kind(String label, String unit, double factor, int places, String more, String less) {
      this.label = label;
      this.unit = unit;
      this.factor = factor;
      this.places = places;
      this.more = more;
      this.less = less;
    }

    String unit() {
      return unit;
    }

    /** As people read it; "" of what was not measured. */
    String text(double value) {
      return Double.isNaN(value)
          ? ""
          : String.format(Locale.ROOT, "%." + places + "f", factor * value + 0.0);
    }
  }

  String label() {
    return (of.isEmpty() ? "" : of + ": ") + what.label;
  }

  /** The same with its unit. */
  String heading() {
    return what.unit.isEmpty() ? label() : "%s (%s)".formatted(label(), what.unit);
  }

  /** How much more the home of that number has than the first; "" where that says nothing. */
  String difference(int home) {
    return home > differences.size()
        ? ""
        : differences.get(home - 1).text(what.factor, what.places);
  }

  /** A sentence, where the difference is shown. */
  Optional<String> claim(int home, String name, String first) {
    if (home > differences.size() || !differences.get(home - 1).isShown(what.factor, what.places)) {
      return Optional.empty();
    }
    boolean isMore = differences.get(home - 1).value() > 0;
    return Optional.of(
        "%s %s %s: %s against %s%s, a difference of %s."
            .formatted(
                name,
                (isMore ? what.more : what.less).formatted(of),
                first,
                cells.get(home),
                cells.get(0),
                what == Kind.REACHED ? "" : " " + what.unit,
                difference(home) + (what.unit.isEmpty() ? "" : " " + what.unit)));
  }
}
