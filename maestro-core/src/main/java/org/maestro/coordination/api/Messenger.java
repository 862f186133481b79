package org.maestro.coordination.api;

import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.sl.Content;

/**
 * The way to people, and to agents that are nobody's members. Answers come on the owner's thread.
 */
public interface Messenger {

  /**
   * Brings a sentence to where people hear it.
   *
   * @param then told once: nothing when it is there, or else one sentence why it is not
   */
  void say(Speech speech, Consumer<Optional<String>> then);

  /**
   * Has people see a mood of the owner's, until it shows another.
   *
   * @param then told once: nothing when it is there, or else one sentence why it is not
   */
  void show(Mood mood, Consumer<Optional<String>> then);

  /**
   * Sends an agent a message.
   *
   * @param part of the script that sends it; it travels along, so that who gets the message twice
   *     can know it
   * @param then told once: nothing when the agent has taken it, or else one sentence why not
   */
  void tell(String part, String agent, Content message, Consumer<Optional<String>> then);

  /**
   * Brings an answer to where answers are kept.
   *
   * @param then run once, when it is there or cannot be brought there
   */
  void keep(GivenAnswer answer, Runnable then);

  /** One where there is neither anybody to hear nor an agent. */
  static Messenger nobody() {
    return new Messenger() {
      @Override
      public void say(Speech speech, Consumer<Optional<String>> then) {
        then.accept(Optional.of("There is no way to tell %s here.".formatted(speech.to())));
      }

      @Override
      public void show(Mood mood, Consumer<Optional<String>> then) {
        then.accept(Optional.of("Nobody is here to see anything."));
      }

      @Override
      public void tell(
          String part, String agent, Content message, Consumer<Optional<String>> then) {
        then.accept(Optional.of("There are no agents here, and no %s.".formatted(agent)));
      }

      @Override
      public void keep(GivenAnswer answer, Runnable then) {
        then.run();
      }
    };
  }
}
