package org.maestro.hal.ros;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.time.Duration;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The connection to a rosbridge server, which all hardware behind that server shares. It connects
 * again by itself when it is lost, after pauses that grow, and then says anew what it listens to
 * and tells. What could not be sent before is forgotten. Any thread may call; none waits, but who
 * closes it.
 */
public final class RosBridge implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(RosBridge.class);

  private static final Duration FIRST_PAUSE = Duration.ofSeconds(1);
  private static final Duration LONGEST_PAUSE = Duration.ofSeconds(30);
  private static final Duration PINGS_EVERY = Duration.ofSeconds(2);

  /** A server that does not even answer pings for so long is connected to anew. */
  private static final Duration GIVEN_UP_AFTER = Duration.ofSeconds(10);

  private static final Duration LEAVES_WITHIN = Duration.ofSeconds(2);
  private static final int MOST_QUOTED = 300;

  /** After what waits before it the server is left. */
  private static final String GOODBYE = "";

  private final URI server;
  private final RosVersion version;
  private final ObjectMapper json = new ObjectMapper();
  private final Outbox outbox = new Outbox();
  private final RosOrders orders;
  private final Map<String, RosTopic<?>> heardOn = new ConcurrentSkipListMap<>();
  private final Map<String, RosType> toldOn = new ConcurrentSkipListMap<>();
  private final Map<String, String> refusals = new ConcurrentHashMap<>();
  private final CountDownLatch end = new CountDownLatch(1);
  private final Thread thread;
  private volatile boolean stands;
  private volatile String missing = "has not answered yet";

  private RosBridge(URI server, RosVersion version) {
    this.server = server;
    this.version = version;
    this.orders = new RosOrders(version, json, outbox);
    this.thread = new Thread(this::keep, "rosbridge");
    thread.setDaemon(true);
  }

  /**
   * Begins to connect.
   *
   * @param server ws or wss; its usual port is 9090
   */
  public static RosBridge open(URI server, RosVersion version) {
    RosBridge bridge = new RosBridge(server, version);
    bridge.thread.start();
    return bridge;
  }

  URI server() {
    return server;
  }

  String typeName(RosType type) {
    return version.typeName(type);
  }

  /**
   * Listens to a topic from now on.
   *
   * @param pause at least so long between two messages
   * @param reading throws a {@link RosMessageException} when a message is not what it is to be
   * @param each told each message, on a thread of the connection's
   */
  synchronized <T> RosTopic<T> listen(
      String topic,
      RosType type,
      Duration pause,
      Function<RosFields, T> reading,
      Consumer<T> each) {
    RosTopic<T> listening = new RosTopic<>(this, topic, type, pause, reading, each);
    heardOn.put(topic, listening);
    if (stands) {
      orders.subscribe(topic, listening);
    }
    return listening;
  }

  /** Tells on a topic from now on. */
  synchronized void advertise(String topic, RosType type) {
    toldOn.put(topic, type);
    if (stands) {
      orders.advertise(topic, type);
    }
  }

  /** Only the last message on each topic counts; while nobody answers none does. */
  synchronized void tell(String topic, ObjectNode message) {
    if (stands) {
      orders.publish(topic, message);
    }
  }

  ObjectNode message() {
    return json.createObjectNode();
  }

  /** Why nothing can be told or heard on a topic now, one sentence for people. */
  Optional<String> fault(String topic, RosType type) {
    if (!stands) {
      return Optional.of("The rosbridge server %s %s.".formatted(server, missing));
    }
    return Optional.ofNullable(refusals.get(topic))
        .map(
            reason ->
                "The rosbridge server %s refuses %s as %s: %s."
                    .formatted(server, topic, typeName(type), reason));
  }

  private void keep() {
    HttpClient client = HttpClient.newHttpClient();
    Duration pause = FIRST_PAUSE;
    while (end.getCount() > 0) {
      try {
        RosSocket socket = RosSocket.connect(client, server, this::heard);
        pause = FIRST_PAUSE;
        begin();
        missing = "does not answer: " + serve(socket);
      } catch (IOException e) {
        missing = "does not answer: " + Objects.requireNonNullElse(e.getMessage(), e.toString());
      } catch (InterruptedException e) {
        end.countDown();
      }
      stands = false;
      heardOn.values().forEach(RosTopic::lost);
      LOG.debug("The rosbridge server {} {}", server, missing);
      pause = pauseThenLonger(pause);
    }
  }

  private Duration pauseThenLonger(Duration pause) {
    try {
      if (end.await(pause.toMillis(), TimeUnit.MILLISECONDS)) {
        return Duration.ZERO;
      }
    } catch (InterruptedException e) {
      end.countDown();
    }
    Duration longer = pause.multipliedBy(2);
    return longer.compareTo(LONGEST_PAUSE) > 0 ? LONGEST_PAUSE : longer;
  }

  private synchronized void begin() {
    outbox.clear();
    refusals.clear();
    toldOn.forEach(orders::advertise);
    heardOn.forEach(orders::subscribe);
    stands = true;
  }

  /** Returns why it is over. */
  private String serve(RosSocket socket) throws IOException, InterruptedException {
    long pinged = System.nanoTime();
    try {
      while (socket.ended().isEmpty()) {
        Optional<String> message = outbox.take(PINGS_EVERY);
        if (message.filter(GOODBYE::equals).isPresent()) {
          socket.leave();
          return "it is not asked any more";
        }
        if (message.isPresent()) {
          socket.send(message.get());
        }
        if (System.nanoTime() - pinged >= PINGS_EVERY.toNanos()) {
          pinged = System.nanoTime();
          socket.ping();
        }
        if (socket.silentFor().compareTo(GIVEN_UP_AFTER) > 0) {
          return "it has been silent for %d s".formatted(GIVEN_UP_AFTER.toSeconds());
        }
      }
      return socket.ended().orElse("");
    } finally {
      socket.cut();
    }
  }

  private void heard(String text) {
    JsonNode message;
    try {
      message = json.readTree(text);
    } catch (JsonProcessingException e) {
      LOG.debug("The rosbridge server {} sent what is no JSON", server);
      return;
    }
    String topic = message.path("topic").asText();
    switch (message.path("op").asText()) {
      case "publish" -> {
        RosTopic<?> listening = heardOn.get(topic);
        if (listening != null) {
          refusals.remove(topic);
          listening.heard(message.path("msg"));
        }
      }
      case "status" -> status(message);
      default -> LOG.debug("The rosbridge server {} sent what nobody asked for", server);
    }
  }

  /** What the server says of an order, by the order's id. */
  private void status(JsonNode status) {
    String id = status.path("id").asText();
    String reason = status.path("msg").asText();
    LOG.debug("The rosbridge server {} says of {}: {}", server, id, reason);
    if (status.path("level").asText().equals("error")) {
      refusals.put(RosOrders.topicOf(id), quoted(reason));
    }
  }

  private static String quoted(String reason) {
    String line = reason.strip().replaceAll("\\s+", " ");
    String whole = line.endsWith(".") ? line.substring(0, line.length() - 1) : line;
    return whole.length() > MOST_QUOTED ? whole.substring(0, MOST_QUOTED) + "…" : whole;
  }

  /** What waits to be told is told before, if that does not take long. */
  @Override
  public void close() {
    outbox.put("goodbye", GOODBYE);
    end.countDown();
    try {
      thread.join(LEAVES_WITHIN.toMillis());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    thread.interrupt();
  }
}
