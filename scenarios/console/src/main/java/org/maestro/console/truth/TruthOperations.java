package org.maestro.console.truth;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.api.Operation;
import org.maestro.console.documents.JsonMembers;
import org.maestro.console.questions.RefusalException;

/** The operation that tells what truly is. */
public final class TruthOperations {
  private TruthOperations() {}

  /**
   * @param truth empty where nothing is simulated
   */
  public static List<Operation> of(Optional<Truth> truth) {
    return List.of(
        Operation.get(
            "/truth",
            "truth",
            "What truly is in a simulated home, beside what is known of it; only where this process"
                + " simulates.",
            "truth",
            request ->
                truth
                    .map(one -> CompletableFuture.completedFuture(document(one)))
                    .orElseGet(
                        () ->
                            CompletableFuture.failedFuture(
                                RefusalException.notThere(
                                    "This process simulates nothing (--no-sim): what is true, nobody"
                                        + " knows; GET /facts tells what is known.")))));
  }

  private static JsonNode document(Truth truth) {
    JsonMembers document = JsonMembers.empty();
    ArrayNode things = document.node().putArray("things");
    for (TrueThing thing : truth.now()) {
      JsonMembers row = JsonMembers.in(things).text("name", thing.name());
      row.node().putNull("at");
      thing.at().ifPresent(spot -> row.node().putArray("at").add(spot.x()).add(spot.y()));
      row.text("holder", thing.holder()).number("level", thing.level());
      row.node().putNull("open");
      thing.open().ifPresent(open -> row.truth("open", open));
    }
    return document.node();
  }
}
