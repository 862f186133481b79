package org.maestro.rats.transport;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.rats.time.Clock;

/**
 * A broker within the process, on a clock: each message takes 1 ms of simulated time, and each
 * delivery is an action of its own, in the order of the receivers' connects. On a stepped clock it
 * is deterministic. It keeps retained messages and publishes wills. Any thread may call it.
 */
public final class InProcessBus {

  /** From publisher to subscriber, and to connect. */
  static final Duration HOP = Duration.ofMillis(1);

  /** Until a client tries again whose place another took. */
  private static final Duration RECONNECT = Duration.ofMillis(200);

  private final Clock clock;
  private final Map<String, InProcessTransport> connected = new LinkedHashMap<>();
  private final List<InProcessTransport> wanting = new ArrayList<>();
  private final Map<String, Kept> retained = new TreeMap<>();
  private final Set<String> cutOff = new TreeSet<>();
  private final Map<String, Duration> slowness = new TreeMap<>();
  private final Map<String, Duration> lastArrival = new TreeMap<>();
  private boolean running = true;
  private volatile Disturbance disturbance = Disturbance.NONE;

  public InProcessBus(Clock clock) {
    this.clock = clock;
  }

  /**
   * A new client; it connects when it is opened. A second client of the same id takes the first
   * one's place.
   */
  public Transport client(String clientId) {
    return client(clientId, clock);
  }

  /**
   * The same for a client in a process of its own: what comes for it, and what it sends, is its own
   * clock's.
   */
  public Transport client(String clientId, Clock own) {
    return new InProcessTransport(this, own, clientId);
  }

  /** The broker goes down: all connections are lost, and so is what it retained. */
  public void stop() {
    List<InProcessTransport> lost;
    synchronized (this) {
      running = false;
      retained.clear();
      lost = List.copyOf(connected.values());
      wanting.addAll(lost);
      connected.clear();
    }
    lost.forEach(client -> client.lost("the bus is down"));
  }

  /** The broker comes back, empty; the clients connect again. */
  public void restart() {
    List<InProcessTransport> returning;
    synchronized (this) {
      running = true;
      returning = List.copyOf(wanting);
      wanting.clear();
    }
    returning.forEach(this::connect);
  }

  /** The client loses its connection, so that its will is published, and gets none until mended. */
  public void cut(String clientId) {
    InProcessTransport lost;
    synchronized (this) {
      cutOff.add(clientId);
      lost = connected.get(clientId);
      if (lost != null) {
        wanting.add(lost);
      }
    }
    if (lost != null) {
      leave(lost, lost.will());
      lost.lost("the connection was cut");
    }
  }

  /** The client may connect again, and does. */
  public void mend(String clientId) {
    List<InProcessTransport> returning;
    synchronized (this) {
      cutOff.remove(clientId);
      returning = wanting.stream().filter(c -> c.clientId().equals(clientId)).toList();
      wanting.removeAll(returning);
    }
    returning.forEach(this::connect);
  }

  /** What the client publishes from now on takes so much longer, and keeps its order. */
  public synchronized void slow(String clientId, Duration extra) {
    slowness.put(clientId, extra);
  }

  /** From now on messages fare so. */
  public void disturb(Disturbance how) {
    disturbance = how;
  }

  Disturbance disturbance() {
    return disturbance;
  }

  /** How long a message takes from this client to the broker if it leaves now. */
  synchronized Duration hop(String clientId) {
    Duration now = clock.now();
    Duration arrival = now.plus(HOP).plus(slowness.getOrDefault(clientId, Duration.ZERO));
    Duration last = lastArrival.getOrDefault(clientId, Duration.ZERO);
    Duration inOrder = arrival.compareTo(last) < 0 ? last : arrival;
    lastArrival.put(clientId, inOrder);
    return inOrder.minus(now);
  }

  void connect(InProcessTransport client) {
    clock.schedule(HOP, client.clientId(), () -> accept(client));
  }

  private void accept(InProcessTransport client) {
    if (!client.wanted()) {
      return;
    }
    InProcessTransport former;
    synchronized (this) {
      if (!running || cutOff.contains(client.clientId())) {
        wanting.add(client);
        return;
      }
      former = connected.remove(client.clientId());
      connected.put(client.clientId(), client);
    }
    if (former != null) {
      former.lost("another client took the id " + client.clientId());
      clock.schedule(RECONNECT, former.clientId(), () -> connect(former));
    }
    client.accepted();
  }

  synchronized boolean holds(InProcessTransport client) {
    return connected.get(client.clientId()) == client;
  }

  /** Takes the client off; its will, if any, is routed as if the client had published it. */
  void remove(InProcessTransport client, Optional<Transport.Will> will) {
    synchronized (this) {
      wanting.remove(client);
    }
    leave(client, will);
  }

  private void leave(InProcessTransport client, Optional<Transport.Will> will) {
    boolean wasConnected;
    synchronized (this) {
      wasConnected = connected.remove(client.clientId(), client);
    }
    if (wasConnected) {
      will.ifPresent(
          last ->
              clock.schedule(
                  HOP,
                  client.clientId(),
                  () ->
                      route(
                          client.clientId(),
                          Publication.retained(last.topic(), last.payload()),
                          clock.now())));
    }
  }

  /** Keeps the message if it is retained, and schedules its deliveries. */
  void route(String from, Publication publication, Duration publishedAt) {
    Kept kept = new Kept(publication, publishedAt);
    List<InProcessTransport> receivers;
    synchronized (this) {
      if (!running) {
        return;
      }
      if (publication.retained() && publication.payload().length == 0) {
        retained.remove(publication.topic());
      } else if (publication.retained()) {
        retained.put(publication.topic(), kept);
      }
      receivers = List.copyOf(connected.values());
    }
    receivers.forEach(
        receiver -> receiver.deliver(from, publication.topic(), () -> kept.message(clock.now())));
  }

  /** What is retained under the filter, in the order of topics. */
  synchronized List<Message> retained(TopicFilter filter) {
    Duration now = clock.now();
    return retained.values().stream()
        .filter(kept -> filter.matches(kept.publication.topic()))
        .flatMap(kept -> kept.message(now).stream())
        .toList();
  }

  private record Kept(Publication publication, Duration publishedAt) {

    /** Empty when it has expired. */
    private Optional<Message> message(Duration now) {
      Optional<Duration> left =
          publication.expiry().map(expiry -> expiry.minus(now.minus(publishedAt)));
      if (left.isPresent() && (left.get().isNegative() || left.get().isZero())) {
        return Optional.empty();
      }
      return Optional.of(
          new Message(publication.topic(), publication.payload(), publication.retained(), left));
    }
  }
}
