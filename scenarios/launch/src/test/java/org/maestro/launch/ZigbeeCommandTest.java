package org.maestro.launch;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** A gateway's lamps become lamps of a home by one command, on one broker for both. */
class ZigbeeCommandTest {

  /** As zigbee2mqtt lists them: by their names, one of the home's, one to be told, one of none. */
  private static final String DEVICES =
      """
      [%s, %s, %s]"""
          .formatted(lamp("0x1", "lamp-b1"), lamp("0x2", "attic/ceiling"), lamp("0x3", "porch"));

  private static String lamp(String address, String name) {
    return """
        {"ieee_address": "%s", "friendly_name": "%s", "type": "Router",
         "definition": {"exposes": [{"type": "light", "features": [
           {"property": "state", "value_on": "ON", "value_off": "OFF"},
           {"property": "brightness", "value_min": 0, "value_max": 254}]}]}}"""
        .formatted(address, name);
  }

  @Test
  void lampsOfAGatewayJoinAsTheHomesAndAreSet() {
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PacedClock clock = new PacedClock(1);
        Transport gateway = new PahoTransport(broker.uri(), "gateway");
        RatsLink link =
            BusLink.connect("cca", "attic", new PahoTransport(broker.uri(), "cca"), clock);
        RunningCommand command = zigbee(broker.uri().toString())) {
      speakAsGateway(gateway);

      Awaitility.await()
          .atMost(Duration.ofSeconds(60))
          .untilAsserted(
              () -> assertThat(ready(link)).as(() -> command.said()).hasSizeGreaterThan(1));
      assertThat(ready(link)).containsExactlyInAnyOrder("lamp-b1", "lamp-a2");
      assertThat(link.members())
          .allSatisfy(member -> assertThat(member.description().orElseThrow()).contains("Lamp"));

      List<Result> results = new CopyOnWriteArrayList<>();
      link.call(
          "lamp-a2",
          "adjustLight",
          Map.of("level", 0.5),
          Duration.ofSeconds(20),
          Optional.empty(),
          results::add);
      Awaitility.await()
          .atMost(Duration.ofSeconds(30))
          .until(() -> !results.isEmpty() && said(link, "lamp-a2").contains("0.5"));
      assertThat(results.get(0).outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(command.said()).as("what it says").contains("lamp-a2").doesNotContain("rror");
    }
  }

  private static RunningCommand zigbee(String broker) {
    return new RunningCommand(
        "zigbee",
        "bob",
        "--gateway",
        broker,
        "--broker",
        broker,
        "--site",
        "attic",
        "--lamp",
        "attic/ceiling=lamp-a2");
  }

  private static List<String> ready(RatsLink link) {
    return link.members().stream()
        .filter(m -> m.phase() == MemberStatus.Phase.READY && m.state().isPresent())
        .map(RatsLink.Member::id)
        .toList();
  }

  private static String said(RatsLink link, String id) {
    return link.members().stream()
        .filter(member -> member.id().equals(id))
        .flatMap(member -> member.state().stream())
        .map(MemberState::values)
        .findFirst()
        .map(Object::toString)
        .orElse("");
  }

  /** Says what lamps there are, and that they do what they are told. */
  private static void speakAsGateway(Transport transport) {
    transport.subscribe(
        "zigbee2mqtt/#",
        Transport.RetainedMessages.IGNORE,
        message -> {
          String topic = message.topic();
          if (topic.endsWith("/set")) {
            say(transport, topic.substring(0, topic.length() - 4), message.payload());
          } else if (topic.endsWith("/get")) {
            byte[] off = "{\"state\":\"OFF\",\"brightness\":254}".getBytes(UTF_8);
            say(transport, topic.substring(0, topic.length() - 4), off);
          }
        });
    transport.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            transport.publish(
                Publication.retained("zigbee2mqtt/bridge/devices", DEVICES.getBytes(UTF_8)),
                failure -> assertThat(failure).isEmpty());
          }

          @Override
          public void lost(String reason) {
            // It tries again.
          }
        });
  }

  private static void say(Transport transport, String topic, byte[] state) {
    transport.publish(
        Publication.reliable(topic, state, Optional.empty()),
        failure -> assertThat(failure).isEmpty());
  }
}
