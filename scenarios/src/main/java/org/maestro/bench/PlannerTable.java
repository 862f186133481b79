package org.maestro.bench;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;

/** The planner's figures as a table: a row for each size of home. */
final class PlannerTable {
  /**
   * One problem.
   *
   * @param firstMilliseconds until the first plan
   * @param milliseconds until the proof, or the deadline
   * @param cost of the best plan; 0 when there is none
   * @param bound no plan costs less; equal to the cost when that is proven
   * @param peers what those did that are installed, each in a few words
   */
  record Entry(
      String wish,
      double firstMilliseconds,
      double milliseconds,
      double cost,
      double bound,
      List<String> peers) {

    private String text() {
      String peer = peers.isEmpty() ? "" : " (" + String.join(", ", peers) + ")";
      return bound >= cost
          ? String.format(Locale.ROOT, "%s %.1f ms%s", wish, milliseconds, peer)
          : String.format(
              Locale.ROOT,
              "%s: gap %.1f %% at %.0f s%s",
              wish,
              100 * (cost - bound) / cost,
              milliseconds / 1000,
              peer);
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
