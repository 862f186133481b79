package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import org.maestro.knowledge.api.QueryAnswer;

/** The rows that answer a query. */
public final class RowsDocument {
  private RowsDocument() {}

  public static JsonNode of(QueryAnswer answer) {
    JsonMembers document =
        JsonMembers.empty().words("variables", answer.variables()).truth("whole", answer.isWhole());
    ArrayNode rows = document.node().putArray("rows");
    answer
        .rows()
        .forEach(
            row -> {
              ObjectNode one = rows.addObject();
              row.forEach(one::put);
            });
    return document.node();
  }
}
