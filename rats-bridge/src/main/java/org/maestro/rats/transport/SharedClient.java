package org.maestro.rats.transport;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.maestro.rats.transport.SharedConnection.Interest;

/** A client of a {@link SharedConnection}, which alone changes what becomes of it. */
final class SharedClient implements Transport {
  private static final long GOODBYE_MILLIS = 2_000;

  private enum Phase {
    DISCONNECTED,
    CONNECTED,
    AWAY,
    GONE
  }

  private final String id;
  private final SharedConnection shared;
  private final List<Interest> interests = new ArrayList<>();
  private Optional<Will> will = Optional.empty();
  private @Nullable ConnectionListener listener;
  private Phase phase = Phase.DISCONNECTED;

  SharedClient(String id, SharedConnection shared) {
    this.id = id;
    this.shared = shared;
  }

  @Override
  public String clientId() {
    return id;
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    shared.subscribe(new Interest(this, TopicFilter.of(filter), retained, handler, false));
  }

  @Override
  public void subscribeToOthers(String filter, MessageHandler handler) {
    shared.subscribe(
        new Interest(this, TopicFilter.of(filter), RetainedMessages.IGNORE, handler, true));
  }

  @Override
  public void askForRetained(String filter) {
    shared.tellKeptAgain(this, filter);
  }

  @Override
  public void open(Optional<Will> lastWill, ConnectionListener connectionListener) {
    will = lastWill;
    listener = connectionListener;
    shared.open(this);
  }

  @Override
  public void stayAway(Duration pause) {
    shared.stayAway(this, pause);
  }

  @Override
  public void publish(Publication publication, Completion completion) {
    shared.publish(this, publication, completion);
  }

  @Override
  public void leave() {
    shared.leave(this, () -> {});
  }

  @Override
  public void close() {
    CountDownLatch left = new CountDownLatch(1);
    shared.leave(this, left::countDown);
    if (!shared.isWithin()) {
      try {
        left.await(GOODBYE_MILLIS, TimeUnit.MILLISECONDS);
      } catch (InterruptedException interrupted) {
        Thread.currentThread().interrupt();
      }
    }
  }

  @Override
  public void die() {
    shared.die(this);
  }

  List<Interest> interests() {
    return interests;
  }

  Optional<Will> will() {
    return will;
  }

  /** There from the opening on; nothing is told before. */
  ConnectionListener listener() {
    return Objects.requireNonNull(listener);
  }

  boolean wantsOnlyOthersOf(String topic) {
    return interests.stream()
        .anyMatch(interest -> interest.ofOthers() && interest.filter().matches(topic));
  }

  boolean isConnected() {
    return phase == Phase.CONNECTED;
  }

  boolean isAway() {
    return phase == Phase.AWAY;
  }

  boolean isGone() {
    return phase == Phase.GONE;
  }

  void connected() {
    phase = Phase.CONNECTED;
  }

  void disconnected() {
    phase = Phase.DISCONNECTED;
  }

  void away() {
    phase = isGone() ? Phase.GONE : Phase.AWAY;
  }

  void back() {
    phase = Phase.DISCONNECTED;
  }

  void gone() {
    phase = Phase.GONE;
  }
}
