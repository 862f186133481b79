package org.maestro.rats.transport;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The messages that a broker keeps, as one who hears all of them knows it. For one thread. */
final class KeptMessages {
  private final Map<String, Message> now = new LinkedHashMap<>();

  /** Those that were kept when the connection was lost, and have not been heard again. */
  private final Map<String, Message> before = new LinkedHashMap<>();

  /**
   * Takes note of a message that has arrived.
   *
   * @return whether it was kept before the connection was lost, and is only sent again
   */
  boolean isSentAgain(Message message) {
    if (!message.retained()) {
      return false;
    }
    Message known = before.remove(message.topic());
    if (message.payload().length == 0) {
      now.remove(message.topic());
      return false;
    }
    now.put(message.topic(), message);
    return known != null && Arrays.equals(known.payload(), message.payload());
  }

  /** What is kept from now on is heard when there is a connection again. */
  void connectionLost() {
    before.putAll(now);
    now.clear();
  }

  List<Message> matching(TopicFilter filter) {
    List<Message> matching = new ArrayList<>();
    if (filter.hasWildcard()) {
      now.values().stream()
          .filter(message -> filter.matches(message.topic()))
          .forEach(matching::add);
    } else if (now.containsKey(filter.text())) {
      matching.add(now.get(filter.text()));
    }
    return matching;
  }
}
