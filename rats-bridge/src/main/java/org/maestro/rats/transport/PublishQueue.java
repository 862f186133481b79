package org.maestro.rats.transport;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The queue of messages that wait to be published, and those under way: Paho throws when more
 * publishes are in progress than the broker allows, so their number is bounded here, and nothing is
 * dropped without telling. Confined to the transport's thread.
 */
final class PublishQueue {

  private static final int MOST_UNDER_WAY = 32;
  private static final int MOST_WAITING = 10_000;

  /** Hands an entry to the connection. */
  interface Sender {
    void send(Entry entry);
  }

  record Entry(Publication publication, Transport.Completion completion, long number) {}

  private final Deque<Entry> waiting = new ArrayDeque<>();
  private final Set<Entry> underWay = new LinkedHashSet<>();
  private int mostUnderWay = MOST_UNDER_WAY;
  private long count;

  /**
   * For what is sent from now on. Paho counts streams too, and one of them may still count when its
   * completion is told.
   *
   * @param receiveMaximum how many publishes the broker lets be under way
   */
  void bound(int receiveMaximum) {
    mostUnderWay = Math.max(1, Math.min(MOST_UNDER_WAY, receiveMaximum - 1));
  }

  void add(Publication publication, Transport.Completion completion, Sender sender) {
    if (waiting.size() >= MOST_WAITING) {
      refuse(publication, completion, MOST_WAITING + " messages wait already");
      return;
    }
    waiting.add(new Entry(publication, completion, count++));
    send(sender);
  }

  /** The connection is done with the entry; empty: the broker took it. */
  void completed(Entry entry, Optional<String> failure, Sender sender) {
    if (underWay.remove(entry)) {
      tell(entry, failure);
      send(sender);
    }
  }

  void failAll(String reason) {
    List<Entry> all = new ArrayList<>(underWay);
    all.addAll(waiting);
    underWay.clear();
    waiting.clear();
    all.forEach(entry -> tell(entry, Optional.of(reason)));
  }

  boolean isEmpty() {
    return waiting.isEmpty() && underWay.isEmpty();
  }

  static void refuse(Publication publication, Transport.Completion completion, String reason) {
    completion.completed(Optional.of(new PublishException(publication.topic(), reason)));
  }

  private void send(Sender sender) {
    while (underWay.size() < mostUnderWay && !waiting.isEmpty()) {
      Entry entry = waiting.remove();
      underWay.add(entry);
      sender.send(entry);
    }
  }

  private static void tell(Entry entry, Optional<String> failure) {
    entry.completion.completed(
        failure.map(reason -> new PublishException(entry.publication.topic(), reason)));
  }
}
