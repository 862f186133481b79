package org.maestro.rats.faults;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/**
 * A broker that is killed and comes back empty, and members that vanish: within a second or five,
 * which other tests beside them would take from them.
 */
@Isolated
abstract class BrokerFaultsContract {

  private static final String SITE = "home";
  private static final int MEMBERS = 10;
  private static final Duration SERVICE_BACK = Duration.ofSeconds(5);
  private static final Duration MEMBER_LOST = Duration.ofSeconds(1);

  private final PacedClock clock = new PacedClock(1);
  private final TestBroker broker = broker();
  private final Map<String, CountingDevice> devices = new TreeMap<>();
  private final Map<String, RatsMember> members = new TreeMap<>();
  private RatsLink link;

  abstract TestBroker broker();

  @BeforeEach
  void open() {
    broker.start();
    for (int number = 0; number < MEMBERS; number++) {
      String id = "m" + number;
      CountingDevice device = new CountingDevice(id, clock, Duration.ofMillis(300));
      devices.put(id, device);
      members.put(
          id,
          RatsMember.start(
              device.profile(), List::of, new PahoTransport(broker.uri(), id), SITE, clock));
    }
    link = BusLink.connect("cca", SITE, new PahoTransport(broker.uri(), "cca"), clock);
    await(Duration.ofSeconds(20), () -> allReady(link));
  }

  @AfterEach
  void close() {
    // Without a broker there is nobody to say goodbye to.
    members.values().forEach(RatsMember::die);
    link.close();
    clock.close();
    broker.stop();
  }

  /** One of the twenty kills, with a fifth of the calls. */
  @Test
  void killedUnderRunningCallsNoneIsLostOrDoneTwice() {
    killUnderCalls(1, 20);
  }

  @Test
  @Tag("full")
  void killedTwentyTimesUnderAHundredRunningCallsNoneIsLostOrDoneTwice() {
    killUnderCalls(20, 100);
  }

  private void killUnderCalls(int kills, int callsEach) {
    for (int kill = 0; kill < kills; kill++) {
      Map<String, Outcomes> calls = new LinkedHashMap<>();
      for (int number = 0; number < callsEach; number++) {
        Outcomes outcomes = new Outcomes();
        calls.put(call("m" + number % MEMBERS, outcomes), outcomes);
      }
      await(
          Duration.ofSeconds(20),
          () -> devices.values().stream().anyMatch(device -> !device.effects.isEmpty()));
      broker.stop();
      broker.start();
      long back = System.nanoTime();
      List<Outcomes> probes = new ArrayList<>();
      await(SERVICE_BACK, () -> allReady(link) && answers(probes));
      assertThat(Duration.ofNanos(System.nanoTime() - back)).isLessThan(SERVICE_BACK);
      await(Duration.ofSeconds(60), () -> calls.values().stream().allMatch(Outcomes::ended));
      assertThat(calls.values()).allMatch(outcomes -> outcomes.results.size() == 1);
      devices
          .values()
          .forEach(device -> assertThat(device.effects.values()).allMatch(times -> times == 1));
      calls.forEach(
          (id, outcomes) -> {
            if (outcomes.succeeded()) {
              assertThat(devices.values()).anyMatch(device -> device.effects.containsKey(id));
            }
          });
    }
  }

  @Test
  void aBrokerThatComesBackEmptyListsAllMembersToANewController() {
    broker.stop();
    broker.start();
    RatsLink other = BusLink.connect("cca2", SITE, new PahoTransport(broker.uri(), "cca2"), clock);
    await(SERVICE_BACK, () -> allReady(other));
    other.close();
  }

  @Test
  void aMemberThatIsKilledIsLostWithinASecond() {
    Outcomes outcomes = new Outcomes();
    call("m3", outcomes);
    long before = System.nanoTime();
    members.get("m3").die();
    await(
        MEMBER_LOST,
        () ->
            link.members().stream()
                .anyMatch(
                    member ->
                        member.id().equals("m3") && member.phase() == MemberStatus.Phase.LOST));
    assertThat(Duration.ofNanos(System.nanoTime() - before)).isLessThan(MEMBER_LOST);
    await(Duration.ofSeconds(2), outcomes::ended);
  }

  /** Whether a call made since then has succeeded; a failed one is made again. */
  private boolean answers(List<Outcomes> probes) {
    if (probes.stream().allMatch(Outcomes::ended)) {
      Outcomes next = new Outcomes();
      probes.add(next);
      call("m0", next);
    }
    return probes.stream().anyMatch(Outcomes::succeeded);
  }

  private String call(String member, RatsLink.CallListener listener) {
    return link.call(member, "deed", Map.of(), Duration.ofSeconds(30), Optional.empty(), listener)
        .callId();
  }

  private static boolean allReady(RatsLink link) {
    List<String> ready = new ArrayList<>();
    link.members().stream()
        .filter(
            member ->
                member.phase() == MemberStatus.Phase.READY
                    && member.description().isPresent()
                    && member.state().isPresent())
        .forEach(member -> ready.add(member.id()));
    return ready.size() == MEMBERS;
  }

  private static void await(Duration limit, BooleanSupplier condition) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(5))
        .atMost(limit)
        .until(condition::getAsBoolean);
  }
}
