package org.maestro.rats.link;

import java.util.function.Consumer;
import org.maestro.rats.protocol.Complaints;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Transport;
import org.maestro.rats.transport.Transport.RetainedMessages;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The subscriptions of one party to the bus, handled on the clock's thread. A message that cannot
 * be read is passed over, and complained of now and then.
 */
final class Subscriptions implements Hearing.Subscriber {

  private static final Logger LOG = LoggerFactory.getLogger(Subscriptions.class);

  private final String party;
  private final Topics topics;
  private final Transport transport;
  private final Clock clock;
  private final Complaints complaints;

  Subscriptions(
      String party, Topics topics, Transport transport, Clock clock, Complaints complaints) {
    this.party = party;
    this.topics = topics;
    this.transport = transport;
    this.clock = clock;
    this.complaints = complaints;
  }

  @Override
  public void subscribe(String filter, RetainedMessages retained, Consumer<Message> handler) {
    transport.subscribe(
        filter, retained, message -> clock.perform(party, () -> handle(handler, message)));
  }

  private void handle(Consumer<Message> handler, Message message) {
    try {
      handler.accept(message);
    } catch (MalformedMessageException malformed) {
      if (complaints.isDue(topics.speakerOf(message.topic()))) {
        LOG.warn("On {}: {}; the message is ignored", message.topic(), malformed.getMessage());
      }
    }
  }
}
