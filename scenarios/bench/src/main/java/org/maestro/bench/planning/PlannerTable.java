package org.maestro.bench.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.maestro.planning.search.Solution;

/** The planner's figures as a table: a row for each size of home. */
final class PlannerTable {
  /**
   * One problem.
   *
   * @param firstMilliseconds until the first plan
   * @param milliseconds until the proof, or the deadline
   * @param end what was known then
   * @param peers what those did that are installed, each in a few words
   */
  record Entry(
      String wish,
      double firstMilliseconds,
      double milliseconds,
      Solution end,
      List<String> peers) {

    private String text() {
      String peer = peers.isEmpty() ? "" : " (" + String.join(", ", peers) + ")";
      return wish + ending() + peer;
    }

    private String ending() {
      return switch (end.verdict()) {
        case OPTIMAL -> String.format(Locale.ROOT, " %.1f ms", milliseconds);
        case UNSOLVABLE -> String.format(Locale.ROOT, ": no plan exists, %.1f ms", milliseconds);
        case PLAN ->
            String.format(
                Locale.ROOT,
                ": gap %.1f %% at %.0f s",
                100.0 * (end.cost() - end.lowerBound()) / end.cost(),
                milliseconds / 1000);
        case OUT_OF_TIME, OUT_OF_MEMORY ->
            String.format(Locale.ROOT, ": nothing found in %.0f s", milliseconds / 1000);
      };
    }
  }

  private final Map<Integer, List<Entry>> byAgents = new LinkedHashMap<>();

  void add(int agents, Entry entry) {
    byAgents.computeIfAbsent(agents, absent -> new ArrayList<>()).add(entry);
  }

  /** One line for each size, after a heading. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    lines.add("");
    lines.add("| agents | first valid plan, slowest goal | proven optimal |");
    lines.add("|---|---|---|");
    byAgents.forEach(
        (agents, entries) ->
            lines.add(
                String.format(
                    Locale.ROOT,
                    "| %,d | %.1f ms | %s |",
                    agents,
                    entries.stream().mapToDouble(Entry::firstMilliseconds).max().orElse(0),
                    String.join("; ", entries.stream().map(Entry::text).toList()))));
    return lines;
  }
}
