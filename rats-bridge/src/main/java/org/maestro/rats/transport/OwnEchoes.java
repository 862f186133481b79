package org.maestro.rats.transport;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;

/**
 * The messages of clients that do not want to hear their own, until they come back from the broker,
 * which does not say who published what. Those of one topic come back in the order in which they
 * were sent. For one thread.
 *
 * @param <C> a client
 */
final class OwnEchoes<C> {
  /** Of one topic; those that were lost on their way are forgotten some time. */
  private static final int MOST = 256;

  private record Echo<C>(C client, byte[] payload) {}

  private final Map<String, Deque<Echo<C>>> expected = new HashMap<>();

  void expect(C client, Publication publication) {
    Deque<Echo<C>> ofTopic =
        expected.computeIfAbsent(publication.topic(), topic -> new ArrayDeque<>());
    if (ofTopic.size() == MOST) {
      ofTopic.removeFirst();
    }
    ofTopic.addLast(new Echo<>(client, publication.payload()));
  }

  /** The client that published the message, if it was one of these. */
  Optional<C> publisher(Message message) {
    Deque<Echo<C>> ofTopic = expected.get(message.topic());
    if (ofTopic == null) {
      return Optional.empty();
    }
    Iterator<Echo<C>> echoes = ofTopic.iterator();
    while (echoes.hasNext()) {
      Echo<C> echo = echoes.next();
      if (Arrays.equals(echo.payload(), message.payload())) {
        echoes.remove();
        if (ofTopic.isEmpty()) {
          expected.remove(message.topic());
        }
        return Optional.of(echo.client());
      }
    }
    return Optional.empty();
  }

  /** None of them comes back any more. */
  void connectionLost() {
    expected.clear();
  }
}
