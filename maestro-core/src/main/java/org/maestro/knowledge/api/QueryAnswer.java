package org.maestro.knowledge.api;

import java.util.List;
import java.util.Map;

/**
 * The answer to a SPARQL SELECT.
 *
 * @param variables in the order in which they were asked for
 * @param rows each by variable, terms as IRIs or lexical forms; what is not bound is left out
 * @param isWhole whether there are no more rows than these
 */
public record QueryAnswer(List<String> variables, List<Map<String, String>> rows, boolean isWhole) {
  public QueryAnswer {
    variables = List.copyOf(variables);
    rows = List.copyOf(rows);
  }
}
