package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;

/** The link over a real broker, one for the class. */
abstract class PahoLinkContract extends LinkContract {

  private static final double SPEED = 20;
  private final PacedClock clock = new PacedClock(SPEED);

  /** The one broker of the class, started. */
  abstract TestBroker broker();

  @AfterEach
  void closeClock() {
    clock.close();
  }

  /** Other classes run beside this one: only its own clients count. */
  static void assertNoThreadIsLeft(TestInfo test) {
    String own = prefix(test.getTestClass().orElseThrow());
    Awaitility.await()
        .atMost(Duration.ofSeconds(5))
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces().keySet())
                    .extracting(Thread::getName)
                    .noneMatch(name -> name.contains(own)));
  }

  private static String prefix(Class<?> test) {
    return test.getSimpleName() + "-";
  }

  /**
   * Three-layered architecture, 2 (M9): the broker knows one client of that id, and drops it
   * whenever the other comes.
   */
  @Test
  void ofTwoMembersOfTheSameIdTheSecondLeaves() {
    try (RatsLink link = BusLink.connect("watch", "twins", client("watch"), clock);
        RatsMember first = joinTwin()) {
      await(() -> isReady(link, first));
      try (RatsMember second = joinTwin()) {
        await(second::isRefused);
        await(() -> isReady(link, first));
        assertThat(first.isRefused()).isFalse();
      }
    }
  }

  private RatsMember joinTwin() {
    MemberProfile profile = new TestDevice("twin", clock).profile();
    return RatsMember.start(profile, List::of, client("twin"), "twins", clock);
  }

  private static boolean isReady(RatsLink link, RatsMember member) {
    return link.members().stream()
        .anyMatch(
            known ->
                known.phase() == MemberStatus.Phase.READY && known.boot().equals(member.boot()));
  }

  @Override
  Clock clock() {
    return clock;
  }

  @Override
  Transport client(String id) {
    return new PahoTransport(broker().uri(), prefix(getClass()) + id);
  }

  @Override
  int seeds() {
    return 2;
  }

  @Override
  void stopBroker() {
    broker().stop();
  }

  @Override
  void restartBroker() {
    broker().start();
  }

  @Override
  void await(BooleanSupplier condition) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(5))
        .atMost(Duration.ofSeconds(20))
        .until(condition::getAsBoolean);
  }
}
