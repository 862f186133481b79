package org.maestro.rats.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.CallPolicy;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;

/** The lamps of a zigbee2mqtt broker, as members of another bus. */
class ZigbeeBridgeTest {

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus zigbee = new InProcessBus(clock);
  private final InProcessBus rats = new InProcessBus(clock);
  private final SimulatedGateway gateway = new SimulatedGateway(zigbee.client("z2m"), clock);
  private RatsLink link;
  private ZigbeeBridge bridge;

  @BeforeEach
  void start() {
    gateway.dimmable("0x1", "kitchen/ceiling");
    gateway.switched("0x2", "porch");
    gateway.sensor("0x3", "thermometer");
    gateway.start();
    bridge =
        ZigbeeBridge.start(
            "zigbee2mqtt",
            zigbee.client("bridge"),
            new ZigbeeBridge.Site("home", rats::client, CallPolicy.OPEN),
            new Role(),
            clock);
    link = BusLink.connect("cca", "home", rats.client("cca"), clock);
    clock.run(Duration.ofSeconds(2));
  }

  @Test
  void presentsItsLightsAndNothingElse() {
    assertThat(link.members())
        .extracting(RatsLink.Member::id)
        .containsExactlyInAnyOrder("kitchen-ceiling", "porch");
    assertThat(facts("kitchen-ceiling"))
        .as("asked for")
        .containsExactly("(= (glow kitchen-ceiling) 0.0)");
  }

  @Test
  void setsALampAndSucceedsWhenItSaysSo() {
    assertThat(call("kitchen-ceiling", 0.5).outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(gateway.orders)
        .containsExactly("kitchen/ceiling {\"state\":\"ON\",\"brightness\":127}");
    assertThat(facts("kitchen-ceiling")).containsExactly("(= (glow kitchen-ceiling) 0.5)");
    assertThat(call("kitchen-ceiling", 0).outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(facts("kitchen-ceiling")).containsExactly("(= (glow kitchen-ceiling) 0.0)");
    assertThat(call("porch", 1).outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(gateway.orders).last().isEqualTo("porch {\"state\":\"ON\"}");
  }

  @Test
  void failsWhenTheLampDoesNotAnswerOrCannotBeReached() {
    gateway.deaf.add("porch");
    Result unanswered = call("porch", 1);
    assertThat(unanswered.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(unanswered.error().orElseThrow().message()).contains("did not answer");
    gateway.availability("porch", "offline");
    clock.run(Duration.ofSeconds(1));
    Result refused = call("porch", 1);
    assertThat(refused.error().orElseThrow().code()).isEqualTo(ErrorCode.DISABLED);
    gateway.deaf.clear();
    gateway.availability("porch", "online");
    clock.run(Duration.ofSeconds(1));
    assertThat(call("porch", 1).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void refusesWhatIsNoShareOfLight() {
    assertThat(call("porch", 7).error().orElseThrow().code())
        .isEqualTo(ErrorCode.INVALID_PARAMETERS);
  }

  @Test
  void saysThatItsGatewayIsAway() {
    gateway.bridgeState("offline");
    clock.run(Duration.ofSeconds(1));
    assertThat(call("porch", 1).error().orElseThrow().message()).contains("gateway");
    gateway.bridgeState("online");
    clock.run(Duration.ofSeconds(1));
    assertThat(call("porch", 1).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void asksAgainEverMoreSeldomUntilItHears() {
    int before = gateway.questions.get("porch").size();
    zigbee.cut("bridge");
    clock.run(Duration.ofSeconds(1));
    gateway.byHand("porch", "ON");
    gateway.missing = Integer.MAX_VALUE;
    zigbee.mend("bridge");
    clock.run(Duration.ofHours(1));
    List<Duration> asked = gateway.questions.get("porch");
    assertThat(facts("porch")).containsExactly("(= (glow porch) 0.0)");
    assertThat(asked).as("in the hour").hasSizeBetween(before + 15, before + 20);
    assertThat(asked.get(before + 1).minus(asked.get(before))).isEqualTo(Duration.ofSeconds(2));

    gateway.missing = 0;
    clock.run(Duration.ofMinutes(6));
    assertThat(facts("porch")).containsExactly("(= (glow porch) 1.0)");
    int answered = gateway.questions.get("porch").size();
    clock.run(Duration.ofHours(1));
    assertThat(gateway.questions.get("porch")).hasSize(answered);
  }

  @Test
  void asksWhenALampOrItsGatewayIsBack() {
    for (boolean ofTheGateway : List.of(true, false)) {
      int before = gateway.questions.get("porch").size();
      away(ofTheGateway, "offline");
      clock.run(Duration.ofMinutes(10));
      assertThat(gateway.questions.get("porch")).as("nobody would hear").hasSize(before);
      gateway.missing = ofTheGateway ? 2 : 0;
      gateway.lamps.get("porch").put("state", ofTheGateway ? "ON" : "OFF");
      away(ofTheGateway, "online");
      clock.run(Duration.ofSeconds(7));
      assertThat(facts("porch"))
          .containsExactly("(= (glow porch) %s)".formatted(ofTheGateway ? "1.0" : "0.0"));
    }
  }

  private void away(boolean gatewayItself, String state) {
    if (gatewayItself) {
      gateway.bridgeState(state);
    } else {
      gateway.availability("porch", state);
    }
  }

  @Test
  void asksForTheListThatTheBrokerLost() {
    InProcessBus others = new InProcessBus(clock);
    LosesRetainedOnce late = new LosesRetainedOnce(zigbee.client("late"));
    ZigbeeBridge.start(
        "zigbee2mqtt",
        late,
        new ZigbeeBridge.Site("annex", others::client, CallPolicy.OPEN),
        new Role(),
        clock);
    RatsLink annex = BusLink.connect("cca", "annex", others.client("cca"), clock);
    clock.run(Duration.ofSeconds(1));
    assertThat(annex.members()).isEmpty();
    clock.run(Duration.ofSeconds(3));
    assertThat(annex.members())
        .extracting(RatsLink.Member::id)
        .containsExactlyInAnyOrder("kitchen-ceiling", "porch");
    clock.run(Duration.ofHours(1));
    assertThat(late.asked()).isEqualTo(1);
  }

  @Test
  void followsTheListOfDevicesAndLeavesWithIt() {
    gateway.remove("porch");
    clock.run(Duration.ofSeconds(1));
    assertThat(link.members()).extracting(RatsLink.Member::id).containsExactly("kitchen-ceiling");
    gateway.garbage("kitchen/ceiling");
    clock.run(Duration.ofSeconds(1));
    assertThat(call("kitchen-ceiling", 1).outcome()).isEqualTo(Outcome.SUCCEEDED);
    bridge.close();
    clock.run(Duration.ofSeconds(1));
    assertThat(link.members()).noneMatch(member -> member.phase() == MemberStatus.Phase.READY);
  }

  private Result call(String lamp, double level) {
    List<Result> results = new ArrayList<>();
    link.call(
        lamp,
        "glow",
        Map.of("share", level),
        Duration.ofSeconds(60),
        Optional.empty(),
        results::add);
    assertThat(clock.runUntil(() -> !results.isEmpty(), Duration.ofSeconds(70))).isTrue();
    clock.run(Duration.ofMillis(50));
    return results.get(0);
  }

  private List<String> facts(String lamp) {
    return link.members().stream()
        .filter(member -> member.id().equals(lamp))
        .findFirst()
        .orElseThrow()
        .state()
        .orElseThrow()
        .values();
  }

  /** Lamps by words that no vocabulary has. */
  private static final class Role implements LampRole {
    @Override
    public Optional<String> id(ZigbeeLamp lamp) {
      return Optional.of(lamp.name().replace('/', '-'));
    }

    @Override
    public String description(String id, ZigbeeLamp lamp) {
      return "{\"@id\":\"" + id + "\"}";
    }

    @Override
    public String feature() {
      return "glow";
    }

    @Override
    public String parameter() {
      return "share";
    }

    @Override
    public String fact(String id, double level) {
      return "(= (glow %s) %s)".formatted(id, level);
    }

    @Override
    public CostAnswer cost(String id, Optional<Double> now, double level) {
      return new CostAnswer(Optional.of(0.3), Optional.of(0.3), Optional.empty());
    }
  }
}
