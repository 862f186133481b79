package org.maestro.rats.faults;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Messages that come twice, late, retained or out of order, and clocks that disagree. */
class MessageFaultsTest {

  private static final String SITE = "home";
  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics(SITE);
  private final WireFormat wire = new WireFormat();
  private final CountingDevice device = new CountingDevice("rose", clock, Duration.ofMillis(20));

  @Test
  void aHundredCallsOfWhichManyComeTwiceLateOrRetained() {
    executesNoneWrongly(100);
  }

  @Test
  @Tag("full")
  void tenThousandCallsOfWhichManyComeTwiceLateOrRetained() {
    executesNoneWrongly(10_000);
  }

  private void executesNoneWrongly(int number) {
    Random chance = new Random(7);
    RatsMember.start(device.profile(), List::of, bus.client("rose"), SITE, clock);
    Transport prompt = open("cca");
    Transport late = open("late");
    clock.run(Duration.ofSeconds(1));
    Map<String, Duration> latestStart = new HashMap<>();
    Set<String> retained = new HashSet<>();
    Set<String> onTime = new HashSet<>();
    for (int index = 0; index < number; index++) {
      String id = "c" + index;
      Duration timeout = Duration.ofMillis(1_000 + chance.nextInt(4_000));
      Call call =
          new Call(
              id,
              Optional.of("rose"),
              Optional.empty(),
              "deed",
              Map.of("n", index),
              timeout,
              "cca",
              Optional.empty());
      Publication publication =
          Publication.reliable(topics.call("cca"), wire.encode(call), Optional.of(timeout));
      latestStart.put(id, clock.now().plus(timeout).plusSeconds(1));
      double dice = chance.nextDouble();
      if (dice < 0.05) {
        retained.add(id);
        send(prompt, Publication.retained(topics.call("cca"), wire.encode(call)));
        send(prompt, Publication.clearing(topics.call("cca")));
      } else if (dice < 0.10) {
        bus.slow("late", Duration.ofMillis(chance.nextInt(10_000)));
        send(late, publication);
      } else {
        onTime.add(id);
        send(prompt, publication);
        if (dice < 0.30) {
          clock.schedule(
              Duration.ofMillis(chance.nextInt(8_000)), "again", () -> send(prompt, publication));
        }
      }
      clock.run(Duration.ofMillis(chance.nextInt(40)));
    }
    clock.run(Duration.ofSeconds(30));
    assertThat(device.effects.values()).as("done twice").containsOnly(1);
    assertThat(device.effects.keySet()).as("retained").doesNotContainAnyElementsOf(retained);
    assertThat(device.effects.keySet()).as("in time").containsAll(onTime);
    device.startedAt.forEach(
        (id, started) -> assertThat(started).as(id).isLessThanOrEqualTo(latestStart.get(id)));
  }

  /** Between the effect and the result; then the same call is sent to the next life. */
  @Test
  void aDeedWhoseDoerDiedBeforeItToldIsNotDoneAgain() {
    RatsMember former =
        RatsMember.start(device.profile(), List::of, bus.client("rose"), SITE, clock);
    RatsLink link = BusLink.connect("cca", SITE, bus.client("cca"), clock);
    clock.run(Duration.ofSeconds(1));
    Outcomes first = new Outcomes();
    RatsLink.Order order =
        new RatsLink.Order(
            Optional.of("d1"),
            "rose",
            Optional.of(former.boot()),
            "deed",
            Map.of(),
            Duration.ofSeconds(60),
            Optional.empty());
    link.call(order, first);
    assertThat(clock.runUntil(() -> !device.effects.isEmpty(), Duration.ofSeconds(5))).isTrue();
    former.die();
    clock.run(Duration.ofSeconds(1));
    assertThat(first.results).singleElement().matches(MessageFaultsTest::isLost);
    RatsMember.start(device.profile(), List::of, bus.client("rose"), SITE, clock);
    clock.run(Duration.ofSeconds(2));
    Outcomes second = new Outcomes();
    link.call(order, second);
    clock.run(Duration.ofSeconds(2));
    assertThat(second.results.get(0).error().orElseThrow().code()).isEqualTo(ErrorCode.RESTARTED);
    Call raw =
        new Call(
            "d1",
            Optional.of("rose"),
            Optional.of(former.boot()),
            "deed",
            Map.of(),
            Duration.ofSeconds(60),
            "cca",
            Optional.empty());
    Transport again = open("again");
    clock.run(Duration.ofSeconds(1));
    send(
        again,
        Publication.reliable(topics.call("cca"), wire.encode(raw), Optional.of(raw.timeout())));
    clock.run(Duration.ofSeconds(2));
    assertThat(device.effects).containsExactly(Map.entry("d1", 1));
  }

  private static boolean isLost(Result result) {
    return result.error().filter(error -> error.code() == ErrorCode.MEMBER_LOST).isPresent();
  }

  @Test
  void clocksThatDifferByAnHourChangeNothing() {
    for (Duration shift : List.of(Duration.ofHours(1), Duration.ofHours(-1))) {
      String id = "m" + (shift.isNegative() ? "past" : "future");
      CountingDevice other = new CountingDevice(id, clock, Duration.ofMillis(20));
      Clock shifted = new ShiftedClock(clock, shift);
      RatsMember.start(other.profile(), List::of, bus.client(id), SITE, shifted);
    }
    RatsLink link = BusLink.connect("cca", SITE, bus.client("cca"), clock);
    clock.run(Duration.ofSeconds(2));
    for (String id : List.of("mpast", "mfuture")) {
      Outcomes outcomes = new Outcomes();
      link.call(id, "deed", Map.of(), Duration.ofSeconds(1), Optional.empty(), outcomes);
      clock.run(Duration.ofSeconds(2));
      assertThat(outcomes.succeeded()).as(id).isTrue();
    }
  }

  /** A will of a former life comes at any moment while the next life takes its place. */
  @Test
  void interleavingsOfTakeoverAndLateWillEndInTheRightStatus() {
    takeOver(10);
  }

  @Test
  @Tag("full")
  void aThousandInterleavingsOfTakeoverAndLateWillEndInTheRightStatus() {
    takeOver(1_000);
  }

  private void takeOver(int interleavings) {
    for (int seed = 0; seed < interleavings; seed++) {
      Random chance = new Random(seed);
      SteppedClock time = new SteppedClock();
      InProcessBus own = new InProcessBus(time);
      CountingDevice doer = new CountingDevice("rose", time, Duration.ofMillis(20));
      RatsMember former =
          RatsMember.start(doer.profile(), List::of, own.client("rose"), SITE, time);
      time.run(Duration.ofMillis(chance.nextInt(30)));
      Transport ghost = own.client("ghost");
      ghost.open(Optional.empty(), new Unconcerned());
      time.run(Duration.ofMillis(5 + chance.nextInt(5)));
      RatsLink link = BusLink.connect("cca", SITE, own.client("cca"), time);
      former.die();
      byte[] will = wire.encode(new MemberStatus("rose", MemberStatus.Phase.LOST, former.boot()));
      for (int again = 0; again < 3; again++) {
        time.schedule(
            Duration.ofMillis(chance.nextInt(40)),
            "will",
            () -> send(ghost, Publication.retained(topics.status("rose"), will)));
      }
      time.run(Duration.ofMillis(chance.nextInt(20)));
      RatsMember next = RatsMember.start(doer.profile(), List::of, own.client("rose"), SITE, time);
      time.run(Duration.ofSeconds(3));
      assertThat(link.members())
          .as("seed " + seed)
          .singleElement()
          .matches(member -> member.phase() == MemberStatus.Phase.READY)
          .matches(member -> member.boot().equals(next.boot()));
    }
  }

  private Transport open(String id) {
    Transport transport = bus.client(id);
    transport.open(Optional.empty(), new Unconcerned());
    return transport;
  }

  private static void send(Transport transport, Publication publication) {
    transport.publish(publication, failure -> assertThat(failure).isEmpty());
  }

  /** The same time, with another idea of what o'clock it is. */
  private record ShiftedClock(Clock clock, Duration shift) implements Clock {
    @Override
    public Duration now() {
      return clock.now();
    }

    @Override
    public Instant start() {
      return clock.start().plus(shift);
    }

    @Override
    public Timer schedule(Duration delay, String owner, Runnable action) {
      return clock.schedule(delay, owner, action);
    }

    @Override
    public Ticket hold(String holder) {
      return clock.hold(holder);
    }
  }

  private static final class Unconcerned implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // The tests look at what becomes of messages.
    }

    @Override
    public void lost(String reason) {
      // The tests look at what becomes of messages.
    }
  }
}
