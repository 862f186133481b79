package org.maestro.bench;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.stream.Stream;

/**
 * The figures of a benchmark, and the machine on which they were measured.
 *
 * @param summary lines for people, after the figures
 */
public record BenchReport(String bench, Machine machine, List<Row> rows, List<String> summary) {
  public BenchReport {
    rows = List.copyOf(rows);
    summary = List.copyOf(summary);
  }

  public BenchReport(String bench, Machine machine, List<Row> rows) {
    this(bench, machine, rows, List.of());
  }

  /**
   * A figure.
   *
   * @param baseline the same measured for what ours is compared with, in the same run
   */
  public record Row(String name, double value, String unit, OptionalDouble baseline) {

    public static Row of(String name, double value, String unit) {
      return new Row(name, value, unit, OptionalDouble.empty());
    }

    OptionalDouble ratio() {
      return baseline.isPresent() && baseline.getAsDouble() != 0
          ? OptionalDouble.of(value / baseline.getAsDouble())
          : OptionalDouble.empty();
    }
  }

  /** A machine, as far as its Java tells. */
  public record Machine(int cores, String architecture, String java) {
    @Override
    public String toString() {
      return "%d cores, %s, Java %s".formatted(cores, architecture, java);
    }
  }

  public static Machine thisMachine() {
    return new Machine(
        Runtime.getRuntime().availableProcessors(),
        System.getProperty("os.arch"),
        Runtime.version().toString());
  }

  /** A line for each figure, and the summary. */
  public List<String> lines() {
    return Stream.concat(rows.stream().map(BenchReport::line), summary.stream()).toList();
  }

  private static String line(Row row) {
    String figure =
        String.format(Locale.ROOT, "%-58s %12.2f %-9s", row.name(), row.value(), row.unit());
    String compared =
        row.ratio().isPresent()
            ? String.format(
                Locale.ROOT,
                " baseline %.2f, ratio %.2f",
                row.baseline().getAsDouble(),
                row.ratio().getAsDouble())
            : "";
    return (figure + compared).stripTrailing();
  }

  /** One document; null where nothing was measured. */
  public String json() {
    ObjectNode document = new ObjectMapper().createObjectNode();
    document.put("bench", bench);
    document
        .putObject("machine")
        .put("cores", machine.cores())
        .put("architecture", machine.architecture())
        .put("java", machine.java());
    var array = document.putArray("rows");
    for (Row row : rows) {
      ObjectNode node = array.addObject().put("name", row.name());
      put(node, "value", OptionalDouble.of(row.value()));
      if (row.unit().isEmpty()) {
        node.putNull("unit");
      } else {
        node.put("unit", row.unit());
      }
      put(node, "baseline", row.baseline());
      put(node, "ratio", row.ratio());
    }
    summary.forEach(document.putArray("summary")::add);
    return document.toString();
  }

  private static void put(ObjectNode node, String name, OptionalDouble figure) {
    if (figure.isPresent() && Double.isFinite(figure.getAsDouble())) {
      node.put(name, figure.getAsDouble());
    } else {
      node.putNull(name);
    }
  }
}
