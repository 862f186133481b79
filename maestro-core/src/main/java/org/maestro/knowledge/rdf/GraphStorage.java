package org.maestro.knowledge.rdf;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.Triple;
import org.apache.jena.sparql.core.Quad;

/**
 * The storage of the RDF dataset: in memory, on disk or behind an endpoint. Thread-safe; each
 * method is one transaction.
 */
public interface GraphStorage extends AutoCloseable {
  /** Makes the edits, in order. */
  void apply(List<Edit> edits);

  /**
   * Rows of a SPARQL SELECT over all graphs, each by variable; terms as IRIs or lexical forms.
   *
   * @param within wall time, after which it is given up
   * @throws org.maestro.knowledge.api.KnowledgeException when it is given up, or is no SPARQL
   */
  List<Map<String, String>> select(String query, Duration within);

  /** The same, however long it takes. */
  default List<Map<String, String>> select(String query) {
    return select(query, Duration.ofDays(1));
  }

  /** Whether the dataset is still there when the process is not. */
  boolean isLasting();

  @Override
  void close();

  /** Puts the triples in the place of all that is in the graph. */
  default void replace(Node graph, List<Triple> triples) {
    apply(List.of(new Edit.Replacement(graph, triples)));
  }

  /**
   * @param forgotten subjects whose statements go, whole, from the graph given with them
   */
  default void commit(List<Quad> removed, List<Subject> forgotten, List<Quad> added) {
    apply(List.of(new Edit.Change(removed, forgotten, added)));
  }

  /** An edit of the dataset, written at once. */
  sealed interface Edit {
    /** Of a statement of three or four terms. */
    long BYTES_OF_A_STATEMENT = 256;

    /** What it takes of memory, about. */
    long bytes();

    /** All that is in the graph from now on. */
    record Replacement(Node graph, List<Triple> triples) implements Edit {
      public Replacement {
        triples = List.copyOf(triples);
      }

      @Override
      public long bytes() {
        return BYTES_OF_A_STATEMENT * (1 + triples.size());
      }
    }

    record Change(List<Quad> removed, List<Subject> forgotten, List<Quad> added) implements Edit {
      public Change {
        removed = List.copyOf(removed);
        forgotten = List.copyOf(forgotten);
        added = List.copyOf(added);
      }

      @Override
      public long bytes() {
        return BYTES_OF_A_STATEMENT * (1 + removed.size() + forgotten.size() + added.size());
      }
    }
  }

  /** All statements of a subject in a graph. */
  record Subject(Node graph, Node subject) {}
}
