package org.maestro.console.chat;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;

/** The way of an answer to a script that has asked. Any thread may answer. */
public interface Answering {

  /**
   * @param question the part of a script that asks
   * @param user who has signed in; empty on an open site
   * @param person of the home whose answer it is
   * @return done when it is taken; refused with the sentence why it is not
   */
  CompletableFuture<Void> answer(
      String question, String text, Optional<String> user, Optional<String> person);
}
