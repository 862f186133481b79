package org.maestro.console.chat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.concurrent.CompletableFuture;
import org.maestro.dialogue.Utterance;

/** The way of words as they are heard. Any thread may tell them. */
public interface WordByWord {

  /**
   * @param words all of the sentence so far
   * @param more whether others are to come
   * @return the document of what comes of them
   */
  CompletableFuture<JsonNode> hear(Utterance words, boolean more);
}
