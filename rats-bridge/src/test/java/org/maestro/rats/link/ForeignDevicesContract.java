package org.maestro.rats.link;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Devices that were not made with this project's runtime, and answer as they see fit. */
abstract class ForeignDevicesContract extends HearsayContract {
  static final String SITE = "abroad";

  @Test
  void aNumberThatIsNoneIsToldAsATextAndWhatHasNoValueIsLeftOut() {
    Stranger stranger = new Stranger("odd");
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "odd"));
    Listener listener = new Listener();
    link.call("odd", "measure", Map.of(), seconds(600), Optional.empty(), listener);
    await(() -> !stranger.calls.isEmpty());
    stranger.answer("\"outcome\":\"SUCCEEDED\",\"z\":\"on\",\"values\":{\"a\":NaN,\"b\":null}");

    await(listener::ended);
    assertThat(listener.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(listener.only().values()).isEqualTo(Map.of("a", "NaN"));
  }

  @Test
  void aResultThatCannotBeReadEndsTheCallAndNamesTheField() {
    Stranger stranger = new Stranger("odd");
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "odd"));
    Listener listener = new Listener();
    link.call("odd", "measure", Map.of(), seconds(600), Optional.empty(), listener);
    await(() -> !stranger.calls.isEmpty());
    stranger.answer("\"outcome\":\"DONE\",\"z\":\"on\",\"values\":{}");

    await(listener::ended);
    assertFailed(listener.only(), ErrorCode.INTERNAL);
    assertThat(listener.only().error().orElseThrow().message())
        .startsWith(
            "odd gave an answer that cannot be read: The message's outcome must be one of ");
  }

  /** It told nothing for longer than the call's time, and then that it is done. */
  @Test
  void whoIsAskedAgainByTheSameIdIsHeardWithWhatItSaidTooLate() {
    Stranger stranger = new Stranger("odd");
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "odd"));
    RatsLink.Order order = brief("c1");
    Listener first = new Listener();
    link.call(order, first);
    await(first::ended);
    assertThat(first.only().outcome()).isEqualTo(Outcome.TIMED_OUT);
    assertThat(first.only().error().orElseThrow().code()).isEqualTo(ErrorCode.MEMBER_LOST);
    Listener other = new Listener();
    link.call("odd", "ping", Map.of(), seconds(600), Optional.empty(), other);
    await(() -> stranger.calls.size() == 2);
    stranger.answer(0, "\"outcome\":\"SUCCEEDED\",\"z\":\"on\",\"values\":{\"lux\":80}");
    stranger.answer(1, "\"outcome\":\"SUCCEEDED\",\"z\":\"on\",\"values\":{}");
    await(other::ended);

    Listener second = new Listener();
    link.call(order, second);
    await(second::ended);
    assertThat(second.only().values()).isEqualTo(Map.of("lux", 80));
    assertThat(stranger.calls).as("it was not asked for it again").hasSize(2);
  }

  @Test
  void whoHasNotSaidAnythingIsAskedAgainInTheSameWords() {
    Stranger stranger = new Stranger("odd");
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "odd"));
    Listener first = new Listener();
    link.call(brief("c1"), first);
    await(first::ended);
    Listener second = new Listener();
    link.call(brief("c1"), second);
    await(() -> stranger.calls.size() == 2);

    assertThat(stranger.calls.get(1).isAgain(stranger.calls.get(0))).isTrue();
    stranger.answer("\"outcome\":\"SUCCEEDED\",\"z\":\"on\",\"values\":{}");
    await(second::ended);
    assertThat(second.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void progressKeepsACallAlive() {
    Stranger stranger = new Stranger("odd");
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "odd"));
    Listener working = new Listener();
    link.call(brief("c1"), working);
    await(() -> !stranger.calls.isEmpty());
    Listener silent = new Listener();
    link.call(brief("c2"), silent);
    clock().schedule(Duration.ofMillis(500), "odd", () -> sayItIsAtIt(stranger, silent));
    await(() -> silent.ended() || working.ended());
    assertThat(working.ended()).isFalse();
    await(() -> working.progress.size() >= 3);
    stranger.answer("\"outcome\":\"SUCCEEDED\",\"z\":\"on\",\"values\":{}");
    await(working::ended);
    assertThat(working.only().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  /** It does not listen to what is said of it. */
  @Test
  void aForgedEndEndsNoStrangerForGoodThatDescribesItself() {
    new Stranger("odd");
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "odd"));
    Forger forger = new Forger(SITE, new Topics(SITE).status("odd"));
    for (String forged : forgeries("odd", "b1").subList(0, 3)) {
      endsNotForGood(link, "odd", "b1", () -> forger.say(forged));
    }
  }

  /** No broker counts the time that passes between it and the member. */
  @Test
  void whatWasHeldUpOnItsWayIsNotBegun() {
    TestDevice device = new TestDevice("anna", clock());
    join(device, SITE);
    RatsLink link = connect("cca", SITE);
    await(() -> usable(link, "anna"));
    Teller teller = new Teller();
    teller.call("c1", "echo", teller.now());
    await(() -> teller.results.size() == 1);
    Call.Sent then = teller.now();
    boolean[] passed = new boolean[1];
    clock().schedule(Duration.ofSeconds(90), "teller", () -> passed[0] = true);
    await(() -> passed[0]);
    teller.call("c2", "drive", then);
    await(() -> teller.results.size() == 2);
    assertThat(teller.results.get(1).outcome()).isEqualTo(Outcome.REJECTED);
    assertThat(teller.results.get(1).error().orElseThrow().code()).isEqualTo(ErrorCode.EXPIRED);

    teller.call("c3", "wave", teller.now());
    teller.call("c4", "wave", new Call.Sent("another", 5));
    await(() -> device.log.stream().filter(line -> line.endsWith("start wave")).count() == 2);
    assertThat(device.log).noneMatch(line -> line.endsWith("start drive"));
  }

  /** Calls for a minute, from a clock that began long ago. */
  private final class Teller {
    final List<Result> results = new CopyOnWriteArrayList<>();
    private final Topics topics = new Topics(SITE);
    private final WireFormat wire = new WireFormat();
    private final Transport transport = client("teller");

    Teller() {
      opened.add(transport::close);
      transport.subscribe(
          topics.results("teller"),
          Transport.RetainedMessages.IGNORE,
          message -> results.add(wire.decodeResult(message.payload())));
      boolean[] there = new boolean[1];
      transport.open(
          Optional.empty(),
          new Transport.ConnectionListener() {
            @Override
            public void connected() {
              there[0] = true;
            }

            @Override
            public void lost(String reason) {
              // It is there again after the next connect.
            }
          });
      await(() -> there[0]);
    }

    Call.Sent now() {
      double wall = clock().now().toMillis() / clock().speed();
      return new Call.Sent("teller-1", 86_400_000 + (long) wall);
    }

    void call(String id, String feature, Call.Sent sent) {
      Call call =
          new Call(
                  id,
                  Optional.of("anna"),
                  Optional.empty(),
                  feature,
                  Map.of("to", "a"),
                  Duration.ofSeconds(60),
                  "teller",
                  Optional.empty())
              .madeAt(sent);
      transport.publish(
          Publication.reliable(topics.call("teller"), wire.encode(call), Optional.empty()),
          failure -> assertThat(failure).isEmpty());
    }
  }

  private void sayItIsAtIt(Stranger stranger, Listener until) {
    stranger.progress("\"kind\":\"RUNNING\",\"fraction\":0.5,\"values\":{}");
    if (!until.ended()) {
      clock().schedule(Duration.ofMillis(500), "odd", () -> sayItIsAtIt(stranger, until));
    }
  }

  private static RatsLink.Order brief(String id) {
    return new RatsLink.Order(
        Optional.of(id),
        "odd",
        Optional.of("b1"),
        "measure",
        Map.of(),
        Duration.ofMillis(300),
        Optional.empty());
  }

  /** A device that speaks for itself in JSON. */
  final class Stranger {
    final List<Call> calls = new CopyOnWriteArrayList<>();
    private final String id;
    private final Topics topics = new Topics(SITE);
    private final WireFormat wire = new WireFormat();
    private final Transport transport;

    Stranger(String id) {
      this.id = id;
      this.transport = client(id);
      opened.add(this::leave);
      transport.subscribe(
          topics.calls(),
          Transport.RetainedMessages.IGNORE,
          message -> {
            Call call = wire.decodeCall(message.payload());
            if (call.feature().equals("$describe")) {
              describe();
            } else if (call.member().filter(id::equals).isPresent()) {
              calls.add(call);
            }
          });
      transport.open(
          Optional.empty(),
          new Transport.ConnectionListener() {
            @Override
            public void connected() {
              describe();
            }

            @Override
            public void lost(String reason) {
              // It is there again after the next connect.
            }
          });
    }

    private void describe() {
      say(topics.description(id), true, "\"label\":\"odd\"");
      say(
          topics.state(id),
          true,
          "\"id\":\"%s\",\"boot\":\"b1\",\"z\":\"on\"".formatted(id)
              + ",\"values\":[],\"running\":[],\"queue\":[],\"disabled\":[]");
      say(
          topics.status(id),
          true,
          "\"id\":\"%s\",\"status\":\"ready\",\"boot\":\"b1\"".formatted(id));
    }

    /**
     * @param rest of the result to its first call, after who speaks of what
     */
    void answer(String rest) {
      answer(0, rest);
    }

    void answer(int call, String rest) {
      say(topics.result("cca", id), false, of(call, rest));
    }

    void progress(String rest) {
      say(topics.progress("cca", id), false, of(0, rest));
    }

    private void leave() {
      for (String topic : List.of(topics.description(id), topics.state(id), topics.status(id))) {
        transport.publish(Publication.clearing(topic), failure -> assertThat(failure).isEmpty());
      }
      transport.close();
    }

    private String of(int call, String rest) {
      return "\"id\":\"%s\",\"from\":\"%s\",%s".formatted(calls.get(call).id(), id, rest);
    }

    private void say(String topic, boolean retain, String fields) {
      byte[] payload = ("{\"v\":\"1.0\"," + fields + "}").getBytes(UTF_8);
      transport.publish(
          retain
              ? Publication.retained(topic, payload)
              : Publication.reliable(topic, payload, Optional.<Duration>empty()),
          failure -> assertThat(failure).isEmpty());
    }
  }
}
