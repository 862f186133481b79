package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashSet;
import java.util.Set;

/** The listeners of one stream of events. For one thread. */
final class Listeners {
  private static final int MOST = 64;

  private final Set<EventQueue> all = new HashSet<>();

  boolean isEmpty() {
    return all.isEmpty();
  }

  /** Returns whether there is room; who finds none is let go. */
  boolean admit(EventQueue listener) {
    if (all.size() >= MOST) {
      listener.end();
      return false;
    }
    return all.add(listener);
  }

  void leave(EventQueue listener) {
    all.remove(listener);
  }

  /** Tells all; who does not take it in time is let go. */
  void tell(String event, JsonNode document) {
    all.removeIf(listener -> !listener.add(event, document));
  }
}
