package org.maestro.knowledge.history;

import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.knowledge.rdf.GraphStorage;
import org.maestro.knowledge.rdf.Graphs;

/** Reads from a storage that outlived its process what was said then. */
public final class StoredHistory {
  private final GraphStorage storage;
  private final Graphs graphs;

  public StoredHistory(GraphStorage storage, Graphs graphs) {
    this.storage = storage;
    this.graphs = graphs;
  }

  /**
   * What was said, in that order.
   *
   * @param since older statements are left out
   */
  public List<HistoryFile.Line> read(Instant since, Instant now) {
    return storage.select(graphs.statementsQuery()).stream()
        .sorted(Comparator.comparingLong(row -> number(told(row, "statement"))))
        .map(row -> line(row, now))
        .flatMap(Optional::stream)
        .filter(line -> !line.belief().since().isBefore(since))
        .toList();
  }

  /** For what the query asks of every statement. */
  private static String told(Map<String, String> row, String variable) {
    return Objects.requireNonNull(row.get(variable));
  }

  private static long number(String observation) {
    try {
      return Long.parseLong(observation.substring(observation.lastIndexOf('-') + 1));
    } catch (NumberFormatException notOurs) {
      return Long.MAX_VALUE;
    }
  }

  /** Others may write to an endpoint, too: what cannot be read is left out. */
  private static Optional<HistoryFile.Line> line(Map<String, String> row, Instant now) {
    try {
      Instant since = Instant.parse(told(row, "time"));
      String agent = told(row, "agent");
      String fact = told(row, "fact");
      FactReader.read(fact, agent);
      Source.Kind kind = Source.Kind.valueOf(told(row, "kind").toUpperCase(Locale.ROOT));
      Belief belief =
          new Belief(
              fact,
              new Source(kind, agent),
              since.isAfter(now) ? now : since,
              Double.parseDouble(told(row, "confidence")));
      return Optional.of(new HistoryFile.Line(belief, row.containsKey("believed")));
    } catch (DateTimeParseException | IllegalArgumentException damaged) {
      return Optional.empty();
    }
  }

  /** The graphs of members that the store knows, but for those named. */
  public List<String> otherMembers(List<String> named) {
    return storage.select(graphs.membersQuery()).stream()
        .map(row -> row.get("graph"))
        .filter(graph -> !named.contains(graph))
        .toList();
  }
}
