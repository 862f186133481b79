package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;

/** Who said what of something, oldest first, and which of it counts now. */
public final class HistoryDocument {
  private HistoryDocument() {}

  public static JsonNode of(List<Belief> history, Snapshot snapshot) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode claims = document.node().putArray("claims");
    history.forEach(
        claim ->
            FactsDocument.add(JsonMembers.in(claims), claim, snapshot)
                .truth("counts", snapshot.beliefs().contains(claim)));
    return document.node();
  }
}
