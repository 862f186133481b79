package org.maestro.console.chat;

import java.util.List;

/** What becomes of an utterance. */
public sealed interface ChatEvent {

  /** A sentence for the person. */
  String text();

  /**
   * It is a goal, which was taken on.
   *
   * @param goal its id
   * @param text the goal, in MAESTRO-SL where it was written so
   */
  record Understood(String goal, String text) implements ChatEvent {}

  /**
   * Something to know.
   *
   * @param goal of which it tells; "" of none
   */
  record Told(String goal, String text) implements ChatEvent {}

  /**
   * A question back; the next utterance may answer it.
   *
   * @param choices answers that would do, some of them when there are many
   */
  record Asked(String text, List<String> choices) implements ChatEvent {
    public Asked {
      choices = List.copyOf(choices);
    }
  }

  /** A goal has ended. */
  record Ended(String goal, boolean reached, String text) implements ChatEvent {}

  /**
   * It was not understood.
   *
   * @param text why, and what to do
   * @param near what may have been meant, each as it can be said
   */
  record Misunderstood(String text, List<String> near) implements ChatEvent {
    public Misunderstood {
      near = List.copyOf(near);
    }
  }
}
