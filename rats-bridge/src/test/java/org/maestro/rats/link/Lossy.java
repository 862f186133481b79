package org.maestro.rats.link;

import java.util.function.Predicate;
import org.maestro.rats.transport.ForwardingTransport;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;

/** A transport that loses some of what it should deliver. */
final class Lossy extends ForwardingTransport {

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

  private final Predicate<Message> isLost;
  private int lost;

  Lossy(Transport transport, Loss loss) {
    super(transport);
    this.isLost = message -> loss.concerns(message) && lost < loss.times();
  }

  Lossy(Transport transport, Predicate<Message> isLost) {
    super(transport);
    this.isLost = isLost;
  }

  int lost() {
    return lost;
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    super.subscribe(
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
}
