package org.maestro.bench.containers;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.util.List;
import java.util.Optional;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/**
 * Members of the bus in appearance only: one client says for all of them what they say of
 * themselves. To be measured are the agents that listen.
 */
final class Crowd implements AutoCloseable {
  private static final String BOOT = "bench";

  private final Transport transport;
  private final Topics topics;
  private final WireFormat wire = new WireFormat();

  /**
   * @param transport not open yet; closed with the crowd
   */
  Crowd(Transport transport, String site) {
    this.transport = transport;
    this.topics = new Topics(site);
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // What is said before is lost: who says it waits.
          }

          @Override
          public void lost(String reason) {
            throw new IllegalStateException("The bus within the process was lost: " + reason);
          }
        });
  }

  /** All devices of the home come, each with its description and its state. */
  void come(Home home) {
    DescriptionWriter writer = new DescriptionWriter(home);
    for (Device device : home.devices().values()) {
      String id = device.id();
      say(topics.description(id), writer.write(device).getBytes(UTF_8));
      say(
          topics.state(id),
          wire.encode(
              new MemberState(id, BOOT, "standby", List.of(), List.of(), List.of(), List.of())));
      say(topics.status(id), wire.encode(new MemberStatus(id, MemberStatus.Phase.READY, BOOT)));
    }
  }

  private void say(String topic, byte[] payload) {
    transport.publish(
        Publication.retained(topic, payload),
        failure ->
            failure.ifPresent(
                cause -> {
                  throw new IllegalStateException("The bench's bus takes no messages.", cause);
                }));
  }

  @Override
  public void close() {
    transport.close();
  }
}
