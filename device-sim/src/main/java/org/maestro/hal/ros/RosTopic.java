package org.maestro.hal.ros;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.Function;

/**
 * What a server tells on one topic, read as what it is to be. Any thread may call; the server's
 * messages come on that of the connection.
 */
final class RosTopic<T> {

  private final RosBridge bridge;
  private final String name;
  private final RosType type;
  private final Duration pause;
  private final Function<RosFields, T> reading;
  private final Consumer<T> each;
  private volatile Optional<Heard<T>> last = Optional.empty();
  private volatile Optional<String> unreadable = Optional.empty();
  private final AtomicLong count = new AtomicLong();

  /**
   * What was told last.
   *
   * @param number counted over all connections
   */
  record Heard<T>(T value, long number, long atNanos) {}

  RosTopic(
      RosBridge bridge,
      String name,
      RosType type,
      Duration pause,
      Function<RosFields, T> reading,
      Consumer<T> each) {
    this.bridge = bridge;
    this.name = name;
    this.type = type;
    this.pause = pause;
    this.reading = reading;
    this.each = each;
  }

  RosType type() {
    return type;
  }

  Duration pause() {
    return pause;
  }

  /** On the thread of the connection. */
  void heard(JsonNode message) {
    T value;
    try {
      value = reading.apply(new RosFields(message));
    } catch (RosMessageException e) {
      unreadable =
          Optional.of(
              "What comes on %s is no %s: %s."
                  .formatted(name, bridge.typeName(type), e.getMessage()));
      return;
    }
    unreadable = Optional.empty();
    last = Optional.of(new Heard<>(value, count.incrementAndGet(), System.nanoTime()));
    each.accept(value);
  }

  /** The connection is lost; what is told next is told on another. */
  void lost() {
    last = Optional.empty();
    unreadable = Optional.empty();
  }

  /** Empty when nothing was told since the connection stands. */
  Optional<Heard<T>> last() {
    return last;
  }

  /**
   * Why what was told last says nothing of now, one sentence for people.
   *
   * @param longestSilence after which it is too old
   */
  Optional<String> fault(Duration longestSilence) {
    return bridge.fault(name, type).or(() -> unreadable).or(() -> silence(longestSilence));
  }

  private Optional<String> silence(Duration longest) {
    Optional<Heard<T>> now = last;
    if (now.isEmpty()) {
      return Optional.of(
          "The rosbridge server %s has told nothing on %s yet, where %s is to come."
              .formatted(bridge.server(), name, bridge.typeName(type)));
    }
    return System.nanoTime() - now.get().atNanos() > longest.toNanos()
        ? Optional.of(
            "The rosbridge server %s has told nothing on %s for more than %d s."
                .formatted(bridge.server(), name, longest.toSeconds()))
        : Optional.empty();
  }
}
