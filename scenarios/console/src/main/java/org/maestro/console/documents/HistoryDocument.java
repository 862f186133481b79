package org.maestro.console.documents;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;

/** Who said what of something, oldest first, and which of it counts now. */
public final class HistoryDocument {
  private HistoryDocument() {}

  public static JsonNode of(List<Belief> history, Snapshot snapshot) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode claims = document.node().putArray("claims");
    Map<Words, Belief> latest = new HashMap<>();
    history.forEach(claim -> latest.put(Words.of(claim), claim));
    Set<Words> believed =
        snapshot.beliefs().stream().map(Words::of).collect(Collectors.toUnmodifiableSet());
    history.forEach(
        claim ->
            FactsDocument.add(JsonMembers.in(claims), claim, snapshot)
                .truth(
                    "counts",
                    believed.contains(Words.of(claim))
                        && claim.equals(latest.get(Words.of(claim)))));
    return document.node();
  }

  /** Who says it again is not told of again: the moment may be another one. */
  private record Words(String fact, Source source) {
    static Words of(Belief belief) {
      return new Words(belief.fact(), belief.source());
    }
  }
}
