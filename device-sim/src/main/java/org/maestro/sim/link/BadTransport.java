package org.maestro.sim.link;

import java.time.Duration;
import java.util.Optional;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A transport whose messages go by a bad link. Connecting and leaving do not. */
final class BadTransport implements Transport {

  private final Transport transport;
  private final BadLink link;

  BadTransport(Transport transport, BadLink link) {
    this.transport = transport;
    this.link = link;
  }

  @Override
  public String clientId() {
    return transport.clientId();
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    transport.subscribe(filter, retained, message -> arrived(message, handler));
  }

  @Override
  public void subscribeToOthers(String filter, MessageHandler handler) {
    transport.subscribeToOthers(filter, message -> arrived(message, handler));
  }

  @Override
  public void askForRetained(String filter) {
    transport.askForRetained(filter);
  }

  private void arrived(Message message, MessageHandler handler) {
    for (int copy = link.copies(); copy > 0; copy--) {
      link.pass(() -> handler.arrived(message));
    }
  }

  @Override
  public void open(Optional<Will> will, ConnectionListener listener) {
    transport.open(will, listener);
  }

  @Override
  public void stayAway(Duration pause) {
    transport.stayAway(pause);
  }

  /** Nobody tells the sender that a message got lost. */
  @Override
  public void publish(Publication publication, Completion completion) {
    int copies = link.copies();
    if (copies == 0) {
      link.pass(() -> completion.completed(Optional.empty()));
      return;
    }
    link.pass(() -> transport.publish(publication, completion));
    if (copies > 1) {
      link.pass(() -> transport.publish(publication, failure -> {}));
    }
  }

  @Override
  public void leave() {
    transport.leave();
  }

  @Override
  public void close() {
    transport.close();
  }

  @Override
  public void die() {
    transport.die();
  }
}
