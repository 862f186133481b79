package org.maestro.dialogue;

import java.util.List;
import java.util.concurrent.CompletableFuture;

/**
 * Somebody who may know what was meant by words that are not understood, such as a language model.
 * What he proposes is no more than something that somebody could have said: it is read, checked and
 * asked back as that would be. Any thread may ask.
 */
@FunctionalInterface
public interface Paraphraser {
  /** Nobody. */
  Paraphraser NOBODY = (said, known) -> CompletableFuture.completedFuture(List.of());

  /**
   * What may have been meant.
   *
   * @param said the words
   * @param known what can be said, and what things are called
   * @return within his own patience, sentences of that kind or formulas in MAESTRO-SL, the
   *     likeliest first; none when he does not know; fails with a sentence when he cannot be asked
   */
  CompletableFuture<List<String>> proposals(String said, Sayable known);
}
