package org.maestro.rats.link;

import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.Verdict;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A controller's verdicts on what members say of themselves: refusals, and that it is right now
 * after one. Retained for each of them, and told again after each connect. Any thread.
 */
final class Verdicts {

  private static final Logger LOG = LoggerFactory.getLogger(Verdicts.class);

  private final String controller;
  private final Topics topics;
  private final Transport transport;
  private final WireFormat wire = new WireFormat();
  private final Map<String, byte[]> latest = new TreeMap<>();

  Verdicts(String controller, Topics topics, Transport transport) {
    this.controller = controller;
    this.topics = topics;
    this.transport = transport;
  }

  /** Tells the member, unless it has been told just that, or all was right before, too. */
  synchronized void tell(Verdict verdict) {
    boolean isNews = latest.containsKey(verdict.member()) || !verdict.accepted();
    if (isNews) {
      byte[] message = wire.encode(verdict);
      if (!Arrays.equals(message, latest.put(verdict.member(), message))) {
        publish(verdict.member(), message);
      }
    }
  }

  /** The broker may have come back empty. */
  synchronized void tellAgain() {
    latest.forEach(this::publish);
  }

  /** The controller leaves for good. */
  synchronized void leave() {
    latest.keySet().forEach(member -> send(Publication.clearing(topic(member))));
    latest.clear();
  }

  private void publish(String member, byte[] message) {
    send(Publication.retained(topic(member), message));
  }

  private String topic(String member) {
    return topics.verdict(controller, member);
  }

  private void send(Publication publication) {
    transport.publish(
        publication, failure -> failure.ifPresent(cause -> LOG.debug("{}", cause.getMessage())));
  }
}
