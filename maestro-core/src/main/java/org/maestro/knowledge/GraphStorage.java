package org.maestro.knowledge;

import java.util.List;
import java.util.Map;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.Triple;
import org.apache.jena.sparql.core.Quad;

/**
 * Where the dataset lives: in memory, on disk or behind an endpoint. Thread-safe; each method is
 * one transaction.
 */
interface GraphStorage extends AutoCloseable {

  /** Puts the triples in the place of all that is in the graph. */
  void replace(Node graph, List<Triple> triples);

  /**
   * @param forgotten subjects whose statements go, whole, from the graph given with them
   */
  void commit(List<Quad> removed, List<Subject> forgotten, List<Quad> added);

  /** Rows of a SPARQL SELECT over all graphs, each by variable; terms as IRIs or lexical forms. */
  List<Map<String, String>> select(String query);

  @Override
  void close();

  /** All statements of a subject in a graph. */
  record Subject(Node graph, Node subject) {}
}
