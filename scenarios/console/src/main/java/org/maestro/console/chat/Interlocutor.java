package org.maestro.console.chat;

import java.util.function.Consumer;
import org.maestro.dialogue.Utterance;

/**
 * Somebody who answers one person, and remembers what they have spoken of. Any thread may speak.
 */
public interface Interlocutor {

  /**
   * Hears an utterance; what is still under way for earlier ones goes on.
   *
   * @param listener told what becomes of it, by any thread, at once and later; it returns at once
   */
  void hear(Utterance utterance, Consumer<ChatEvent> listener);
}
