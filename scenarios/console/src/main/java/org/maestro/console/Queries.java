package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.concurrent.CompletableFuture;
import org.maestro.console.documents.RowsDocument;
import org.maestro.console.questions.RefusalException;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.KnowledgeException;

/** SPARQL over all that is known, read only; one query after the other. Any thread may ask. */
final class Queries implements AutoCloseable {
  private final KnowledgeBase knowledge;
  private final OneByOne asking =
      new OneByOne("console-queries", "Other queries are being answered; ask again in a while.");

  Queries(KnowledgeBase knowledge) {
    this.knowledge = knowledge;
  }

  CompletableFuture<JsonNode> of(String sparql) {
    return asking.work(
        () -> {
          try {
            return RowsDocument.of(knowledge.query(sparql));
          } catch (KnowledgeException e) {
            throw RefusalException.badInput(String.valueOf(e.getMessage()));
          }
        });
  }

  @Override
  public void close() {
    asking.close();
  }
}
