package org.maestro.rats.gateway;

import java.time.Duration;
import java.util.Optional;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** What is retained gets lost on its way until it is asked for, as can happen with a broker. */
final class LosesRetainedOnce implements Transport {

  private final Transport transport;
  private int asked;

  LosesRetainedOnce(Transport transport) {
    this.transport = transport;
  }

  int asked() {
    return asked;
  }

  @Override
  public String clientId() {
    return transport.clientId();
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    transport.subscribe(
        filter,
        retained,
        message -> {
          if (asked > 0 || !message.retained()) {
            handler.arrived(message);
          }
        });
  }

  @Override
  public void subscribeToOthers(String filter, MessageHandler handler) {
    transport.subscribeToOthers(filter, handler);
  }

  @Override
  public void askForRetained(String filter) {
    asked++;
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
  public void close() {
    transport.close();
  }

  @Override
  public void die() {
    transport.die();
  }
}
