package org.maestro.rats.link;

import java.time.Duration;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A transport that loses some of what it should deliver. */
final class Lossy implements Transport {

  /**
   * What gets lost.
   *
   * @param word the last level of the topic; empty: all that members say of themselves
   * @param times how often, from the beginning
   */
  record Loss(String word, int times) {
    private boolean concerns(Message message) {
      return message.topic().contains("/member/") && message.topic().endsWith(word);
    }
  }

  private final Transport transport;
  private final Predicate<Message> isLost;
  private int lost;

  Lossy(Transport transport, Loss loss) {
    this.transport = transport;
    this.isLost = message -> loss.concerns(message) && lost < loss.times();
  }

  Lossy(Transport transport, Predicate<Message> isLost) {
    this.transport = transport;
    this.isLost = isLost;
  }

  int lost() {
    return lost;
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
          if (isLost.test(message)) {
            lost++;
          } else {
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
