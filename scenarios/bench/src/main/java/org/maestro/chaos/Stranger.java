package org.maestro.chaos;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.TreeMap;
import org.maestro.rats.protocol.MalformedMessageException;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Message;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Somebody on an open site who speaks in the names of others, or says what nobody can read. */
final class Stranger {
  private static final Duration A_LOOK = Duration.ofMillis(100);
  private static final int PIECES = 20;

  private final Transport transport;
  private final Clock clock;
  private final Map<String, String> bootsByTopic = new TreeMap<>();

  private Stranger(Transport transport, Clock clock) {
    this.transport = transport;
    this.clock = clock;
  }

  static Stranger on(InProcessBus bus, Clock clock) {
    Stranger stranger = new Stranger(bus.client("stranger"), clock);
    stranger.transport.subscribe(
        "rats/1/+/member/+/status", Transport.RetainedMessages.SEND, stranger::heard);
    stranger.transport.open(Optional.empty(), new Unconcerned());
    clock.schedule(A_LOOK.multipliedBy(2), "stranger", stranger.transport::close);
    return stranger;
  }

  private void heard(Message message) {
    try {
      if (message.payload().length > 0) {
        MemberStatus status = new WireFormat().decodeStatus(message.payload());
        bootsByTopic.put(message.topic(), status.boot());
      }
    } catch (MalformedMessageException others) {
      bootsByTopic.remove(message.topic());
    }
  }

  /**
   * @param phase empty: the status is cleared
   * @param boot own: the one that the member really has
   */
  void forges(int which, String phase, String boot) {
    clock.schedule(
        A_LOOK,
        "stranger",
        () -> {
          if (!bootsByTopic.isEmpty()) {
            String topic = List.copyOf(bootsByTopic.keySet()).get(which % bootsByTopic.size());
            String member = topic.split("/")[4];
            String life = boot.equals("own") ? bootsByTopic.get(topic) : boot;
            say(
                topic,
                phase.isEmpty()
                    ? ""
                    : "{\"v\":\"1.0\",\"id\":\"%s\",\"status\":\"%s\",\"boot\":\"%s\"}"
                        .formatted(member, phase, life));
          }
        });
  }

  /** On the topics of those who are there. */
  void litters(Random chance) {
    clock.schedule(
        A_LOOK,
        "stranger",
        () -> {
          List<String> topics = List.copyOf(bootsByTopic.keySet());
          for (int piece = 0; piece < PIECES && !topics.isEmpty(); piece++) {
            String status = topics.get(chance.nextInt(topics.size()));
            String site = status.substring(0, status.indexOf("/member"));
            String member = status.split("/")[4];
            String topic =
                List.of(
                        status,
                        status.replace("/status", "/state"),
                        site + "/call/stranger",
                        site + "/call",
                        site + "/result/maestro/" + member,
                        site + "/progress/maestro/" + member,
                        status.replace("/status", "/observation/look"))
                    .get(chance.nextInt(7));
            say(topic, rubbish(chance, member));
          }
        });
  }

  private static String rubbish(Random chance, String member) {
    return List.of(
            "{",
            "null",
            "[1,2,3]",
            "{\"v\":\"1.0\",\"id\":\"\\ud800\",\"r\":\"" + member + "\"}",
            "{\"v\":\"1.0\",\"id\":\"" + member + "\",\"status\":\"dancing\",\"boot\":\"b\"}",
            "{\"v\":\"1.0\",\"id\":\"x\",\"r\":\"%s\",\"f\":\"fly\",\"t\":1,\"from\":\"stranger\"}"
                .formatted(member),
            "{\"v\":\"9.0\",\"id\":\"x\"}",
            "\u0000\u0001")
        .get(chance.nextInt(8));
  }

  private void say(String topic, String text) {
    boolean retained = topic.contains("/member/") && !topic.contains("/observation/");
    Publication publication =
        retained
            ? Publication.retained(topic, ChaosFaults.text(text))
            : Publication.reliable(topic, ChaosFaults.text(text), Optional.empty());
    transport.publish(publication, failure -> {});
  }

  /** Connections do not matter to who only looks on, or does harm. */
  static final class Unconcerned implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // It looks at messages.
    }

    @Override
    public void lost(String reason) {
      // It comes back by itself.
    }
  }
}
