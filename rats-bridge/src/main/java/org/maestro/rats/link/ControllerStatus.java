package org.maestro.rats.link;

import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A controller's retained status and last will, kept right against what others say in its name:
 * members end after a while what runs for one that is gone. Clock thread only, but for {@link
 * #leave}.
 */
final class ControllerStatus {

  private static final Logger LOG = LoggerFactory.getLogger(ControllerStatus.class);

  private final String controller;
  private final String boot;
  private final String topic;
  private final Transport transport;
  private final WireFormat wire = new WireFormat();
  private volatile boolean left;

  ControllerStatus(String controller, String boot, Topics topics, Transport transport) {
    this.controller = controller;
    this.boot = boot;
    this.topic = topics.controllerStatus(controller);
    this.transport = transport;
  }

  Transport.Will will() {
    return new Transport.Will(topic, status(MemberStatus.Phase.LOST));
  }

  void ready() {
    publish(Publication.retained(topic, status(MemberStatus.Phase.READY)));
  }

  /**
   * A will that came late, or another's word, must not stay the last that members hear. Of another
   * life that says that it is there nothing is known here, and it is not contradicted.
   */
  void heard(Message message) {
    boolean gone =
        message.payload().length == 0
            || switch (wire.decodeStatus(message.payload()).phase()) {
              case LOST, DISCONNECTED -> true;
              case INIT, READY -> false;
            };
    if (gone && !left) {
      ready();
    }
  }

  /** For good. Any thread. */
  void leave() {
    left = true;
    publish(Publication.clearing(topic));
  }

  private void publish(Publication publication) {
    transport.publish(
        publication, failure -> failure.ifPresent(cause -> LOG.debug("{}", cause.getMessage())));
  }

  private byte[] status(MemberStatus.Phase phase) {
    return wire.encode(new MemberStatus(controller, phase, boot));
  }
}
