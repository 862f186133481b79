package org.maestro.coordination.achievement;

import java.util.HashSet;
import java.util.Set;
import org.maestro.coordination.api.ActionDispatcher;

/**
 * The members that have told how things are, asked once more: what they said may be older than the
 * deed that it is about. The coordinator's thread only.
 */
final class Speakers {
  private Speakers() {}

  /**
   * @param heard is run once all have said what they say, or say nothing
   */
  static void ask(Set<String> members, ActionDispatcher dispatcher, Runnable heard) {
    Set<String> awaited = new HashSet<>(members);
    for (String member : members) {
      dispatcher.ask(
          member,
          () -> {
            awaited.remove(member);
            if (awaited.isEmpty()) {
              heard.run();
            }
          });
    }
  }
}
