package org.maestro.rats.transport;

import java.time.Duration;
import java.util.Optional;

/** A transport that hands all on to another; a test says what it does otherwise. */
public abstract class ForwardingTransport implements Transport {

  private final Transport transport;

  protected ForwardingTransport(Transport transport) {
    this.transport = transport;
  }

  @Override
  public String clientId() {
    return transport.clientId();
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    transport.subscribe(filter, retained, handler);
  }

  @Override
  public void subscribeToOthers(String filter, MessageHandler handler) {
    transport.subscribeToOthers(filter, handler);
  }

  @Override
  public void askForRetained(String filter) {
    transport.askForRetained(filter);
  }

  @Override
  public void open(Optional<Will> will, ConnectionListener listener) {
    transport.open(will, listener);
  }

  @Override
  public void stayAway(Duration pause) {
    transport.stayAway(pause);
  }

  @Override
  public void publish(Publication publication, Completion completion) {
    transport.publish(publication, completion);
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
