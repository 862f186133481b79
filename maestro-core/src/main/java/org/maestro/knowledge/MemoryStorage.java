package org.maestro.knowledge;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.Triple;
import org.apache.jena.query.DatasetFactory;
import org.apache.jena.query.QueryExecution;
import org.apache.jena.query.QueryParseException;
import org.apache.jena.query.ResultSet;
import org.apache.jena.rdf.model.RDFNode;
import org.apache.jena.sparql.core.DatasetGraph;
import org.apache.jena.sparql.core.DatasetGraphFactory;
import org.apache.jena.sparql.core.Quad;
import org.apache.jena.sys.JenaSystem;
import org.apache.jena.system.Txn;

/**
 * Jena's transactional dataset in memory, by its graph interface: SPARQL Update text costs five
 * times as much.
 */
final class MemoryStorage implements GraphStorage {

  private final DatasetGraph dataset;

  MemoryStorage() {
    JenaSystem.init();
    dataset = DatasetGraphFactory.createTxnMem();
  }

  @Override
  public void replace(Node graph, List<Triple> triples) {
    Txn.executeWrite(
        dataset,
        () -> {
          dataset.deleteAny(graph, Node.ANY, Node.ANY, Node.ANY);
          triples.forEach(triple -> dataset.add(Quad.create(graph, triple)));
        });
  }

  @Override
  public void commit(List<Quad> removed, List<Subject> forgotten, List<Quad> added) {
    Txn.executeWrite(
        dataset,
        () -> {
          removed.forEach(dataset::delete);
          forgotten.forEach(
              gone -> dataset.deleteAny(gone.graph(), gone.subject(), Node.ANY, Node.ANY));
          added.forEach(dataset::add);
        });
  }

  @Override
  public List<Map<String, String>> select(String query) {
    try {
      return Txn.calculateRead(
          dataset,
          () -> {
            try (QueryExecution execution =
                QueryExecution.dataset(DatasetFactory.wrap(dataset)).query(query).build()) {
              return rows(execution.execSelect());
            }
          });
    } catch (QueryParseException e) {
      throw new KnowledgeException(
          "The query is not SPARQL: " + e.getMessage() + " Correct it there.", e);
    }
  }

  private static List<Map<String, String>> rows(ResultSet results) {
    List<Map<String, String>> rows = new ArrayList<>();
    results.forEachRemaining(
        solution -> {
          Map<String, String> row = new TreeMap<>();
          solution.varNames().forEachRemaining(name -> row.put(name, text(solution.get(name))));
          rows.add(row);
        });
    return rows;
  }

  private static String text(RDFNode node) {
    return node.isLiteral() ? node.asLiteral().getLexicalForm() : node.toString();
  }

  @Override
  public void close() {
    dataset.close();
  }
}
