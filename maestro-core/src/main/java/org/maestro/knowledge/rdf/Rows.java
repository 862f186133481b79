package org.maestro.knowledge.rdf;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.apache.jena.query.QueryException;
import org.apache.jena.query.ResultSet;
import org.apache.jena.rdf.model.RDFNode;
import org.maestro.knowledge.api.KnowledgeException;

/** Answers to a SPARQL SELECT without Jena's types. */
final class Rows {
  private Rows() {}

  static List<Map<String, String>> of(ResultSet results) {
    List<Map<String, String>> rows = new ArrayList<>();
    results.forEachRemaining(
        solution -> {
          Map<String, String> row = new TreeMap<>();
          solution.varNames().forEachRemaining(name -> row.put(name, text(solution.get(name))));
          rows.add(row);
        });
    return rows;
  }

  static KnowledgeException noQuery(QueryException e) {
    return new KnowledgeException(
        "The query is not SPARQL: " + e.getMessage() + " Correct it there.", e);
  }

  private static String text(RDFNode node) {
    return node.isLiteral() ? node.asLiteral().getLexicalForm() : node.toString();
  }
}
