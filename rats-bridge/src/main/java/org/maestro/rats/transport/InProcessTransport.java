package org.maestro.rats.transport;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.maestro.rats.time.Clock;

/** A client of the {@link InProcessBus}. */
final class InProcessTransport implements Transport {

  private final InProcessBus bus;
  private final Clock clock;
  private final String clientId;
  private final List<Subscription> subscriptions = new ArrayList<>();
  private Optional<Will> will = Optional.empty();
  private @Nullable ConnectionListener listener;
  private boolean wanted;
  private boolean away;

  InProcessTransport(InProcessBus bus, Clock clock, String clientId) {
    this.bus = bus;
    this.clock = clock;
    this.clientId = clientId;
  }

  @Override
  public String clientId() {
    return clientId;
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    add(new Subscription(TopicFilter.of(filter), retained, handler, false));
  }

  @Override
  public void subscribeToOthers(String filter, MessageHandler handler) {
    add(new Subscription(TopicFilter.of(filter), RetainedMessages.IGNORE, handler, true));
  }

  private void add(Subscription subscription) {
    synchronized (this) {
      subscriptions.add(subscription);
    }
    if (bus.holds(this)) {
      sendRetained(subscription);
    }
  }

  @Override
  public void askForRetained(String filter) {
    if (bus.holds(this)) {
      subscriptions().stream()
          .filter(subscription -> subscription.filter.text().equals(filter))
          .forEach(this::sendRetained);
    }
  }

  @Override
  public void open(Optional<Will> lastWill, ConnectionListener connectionListener) {
    synchronized (this) {
      will = lastWill;
      listener = connectionListener;
      wanted = true;
    }
    bus.connect(this);
  }

  @Override
  public void publish(Publication publication, Completion completion) {
    if (!bus.holds(this)) {
      completion.completed(
          Optional.of(new PublishException(publication.topic(), "there is no connection")));
      return;
    }
    Duration publishedAt = clock.now();
    Duration hop = bus.hop(clientId);
    for (Disturbance.Copy copy : bus.disturbance().published(clientId, publication)) {
      clock.schedule(
          hop.plus(copy.later()),
          clientId,
          () -> bus.route(clientId, copy.publication(), publishedAt));
    }
    clock.schedule(hop, clientId, () -> completion.completed(Optional.empty()));
  }

  @Override
  public void stayAway(Duration pause) {
    synchronized (this) {
      wanted = false;
      away = true;
    }
    bus.remove(this, Optional.empty());
    clock.schedule(pause, clientId, this::comeBack);
  }

  private void comeBack() {
    synchronized (this) {
      if (!away) {
        return;
      }
      away = false;
      wanted = true;
    }
    bus.connect(this);
  }

  @Override
  public void leave() {
    leave(Optional.empty());
  }

  @Override
  public void close() {
    leave();
  }

  @Override
  public void die() {
    leave(will);
  }

  private void leave(Optional<Will> lastWill) {
    synchronized (this) {
      wanted = false;
      away = false;
    }
    bus.remove(this, lastWill);
  }

  synchronized Optional<Will> will() {
    return will;
  }

  synchronized boolean wanted() {
    return wanted;
  }

  void accepted() {
    clock.schedule(Duration.ZERO, clientId, () -> whileConnected(listener()::connected));
    subscriptions().forEach(this::sendRetained);
  }

  /** There from the opening on; nothing connects before. */
  private ConnectionListener listener() {
    return Objects.requireNonNull(listener);
  }

  void lost(String reason) {
    clock.schedule(
        Duration.ZERO,
        clientId,
        () -> {
          if (wanted()) {
            listener().lost(reason);
          }
        });
  }

  /** Schedules one action for each subscription that matches. */
  void deliver(String from, String topic, Supplier<Optional<Message>> message) {
    for (Subscription subscription : subscriptions()) {
      boolean wanted = !subscription.ofOthers || !from.equals(clientId);
      if (wanted && subscription.filter.matches(topic)) {
        clock.schedule(
            bus.disturbance().heardLater(clientId),
            clientId,
            () -> whileConnected(() -> message.get().ifPresent(subscription.handler::arrived)));
      }
    }
  }

  private void sendRetained(Subscription subscription) {
    if (subscription.retained == RetainedMessages.IGNORE) {
      return;
    }
    for (Message message : bus.retained(subscription.filter)) {
      clock.schedule(
          Duration.ZERO,
          clientId,
          () -> whileConnected(() -> subscription.handler.arrived(message)));
    }
  }

  private void whileConnected(Runnable action) {
    if (bus.holds(this)) {
      action.run();
    }
  }

  private synchronized List<Subscription> subscriptions() {
    return List.copyOf(subscriptions);
  }

  private record Subscription(
      TopicFilter filter, RetainedMessages retained, MessageHandler handler, boolean ofOthers) {}
}
