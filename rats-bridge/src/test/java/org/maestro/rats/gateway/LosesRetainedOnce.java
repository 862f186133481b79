package org.maestro.rats.gateway;

import org.maestro.rats.transport.ForwardingTransport;
import org.maestro.rats.transport.Transport;

/** What is retained gets lost on its way until it is asked for, as can happen with a broker. */
final class LosesRetainedOnce extends ForwardingTransport {

  private int asked;

  LosesRetainedOnce(Transport transport) {
    super(transport);
  }

  int asked() {
    return asked;
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, MessageHandler handler) {
    super.subscribe(
        filter,
        retained,
        message -> {
          if (asked > 0 || !message.retained()) {
            handler.arrived(message);
          }
        });
  }

  @Override
  public void askForRetained(String filter) {
    asked++;
    super.askForRetained(filter);
  }
}
