package org.maestro.rats.faults;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;

/**
 * A member in a process of its own that is frozen: its connection stays open, and nothing comes.
 */
@Isolated("its time is wall time, which others beside it would take")
@DisabledOnOs(OS.WINDOWS)
class FrozenMemberTest {
  private static final Duration KEEP_ALIVE = Duration.ofSeconds(2);
  private static final Duration COMES_WITHIN = Duration.ofSeconds(60);

  @Test
  void aFrozenMemberIsNoticedWithinTwoKeepAlivesAndIsBackWhenItThaws() throws Exception {
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PacedClock clock = new PacedClock(1);
        RatsLink link =
            BusLink.connect("cca", "home", new PahoTransport(broker.uri(), "cca"), clock)) {
      Process process = member(broker.uri());
      try {
        await(() -> is(link, MemberStatus.Phase.READY), COMES_WITHIN);
        signal("STOP", process);
        long frozen = System.nanoTime();
        await(() -> is(link, MemberStatus.Phase.LOST), COMES_WITHIN);
        assertThat(Duration.ofNanos(System.nanoTime() - frozen))
            .isLessThan(KEEP_ALIVE.multipliedBy(2));
        signal("CONT", process);
        await(() -> is(link, MemberStatus.Phase.READY), COMES_WITHIN);
      } finally {
        process.destroyForcibly().onExit().join();
      }
    }
  }

  /**
   * The call lies in the member's socket while it stands still: the broker has delivered it in
   * time, and the connection is never lost.
   */
  @Test
  @Tag("full")
  void whatReachedItWhileItWasFrozenForLongerThanTIsNotBegunWhenItThaws() throws Exception {
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        PacedClock clock = new PacedClock(1);
        RatsLink link =
            BusLink.connect("cca", "home", new PahoTransport(broker.uri(), "cca"), clock)) {
      Process process = member(broker.uri(), Duration.ofSeconds(60));
      try {
        await(() -> is(link, MemberStatus.Phase.READY), COMES_WITHIN);
        assertThat(outcome(link, "echo", Duration.ofSeconds(30)).join().outcome())
            .as("by which it knows the caller's clock")
            .isEqualTo(Outcome.SUCCEEDED);
        signal("STOP", process);
        await(() -> isStill(process), COMES_WITHIN);
        Duration frozen = clock.now();
        Duration t = Duration.ofSeconds(1);
        CompletableFuture<Result> late = outcome(link, "drive", t);
        CompletableFuture<Result> inTime = outcome(link, "wave", Duration.ofSeconds(60));
        await(() -> clock.now().minus(frozen).compareTo(t.multipliedBy(3)) > 0, COMES_WITHIN);
        signal("CONT", process);
        assertThat(late.join().outcome()).isEqualTo(Outcome.REJECTED);
        assertThat(late.join().error().orElseThrow().code()).isEqualTo(ErrorCode.EXPIRED);
        assertThat(inTime.join().outcome()).isEqualTo(Outcome.SUCCEEDED);
      } finally {
        process.destroyForcibly().onExit().join();
      }
    }
  }

  private static CompletableFuture<Result> outcome(RatsLink link, String feature, Duration t) {
    CompletableFuture<Result> outcome = new CompletableFuture<>();
    link.call("anna", feature, Map.of("to", "a"), t, Optional.empty(), outcome::complete);
    return outcome.orTimeout(COMES_WITHIN.toSeconds(), TimeUnit.SECONDS);
  }

  private static boolean is(RatsLink link, MemberStatus.Phase phase) {
    return link.members().stream().anyMatch(member -> member.phase() == phase);
  }

  private static void await(BooleanSupplier condition, Duration limit) {
    Awaitility.await()
        .pollInterval(Duration.ofMillis(20))
        .atMost(limit)
        .until(condition::getAsBoolean);
  }

  private static Process member(URI broker) throws IOException {
    return member(broker, KEEP_ALIVE);
  }

  private static Process member(URI broker, Duration keepAlive) throws IOException {
    return new ProcessBuilder(
            Path.of(System.getProperty("java.home"), "bin", "java").toString(),
            "-XX:TieredStopAtLevel=1",
            "-cp",
            System.getProperty("java.class.path"),
            Member.class.getName(),
            broker.toString(),
            keepAlive.toString())
        .redirectErrorStream(true)
        .redirectOutput(ProcessBuilder.Redirect.DISCARD)
        .start();
  }

  private static void signal(String name, Process process) throws Exception {
    assertThat(
            new ProcessBuilder(List.of("kill", "-" + name, Long.toString(process.pid())))
                .start()
                .waitFor())
        .isZero();
  }

  /**
   * Whether each of its threads stands: the signal is sent to the process, and the first thread
   * that runs after it stops the others, until when they may go on for a moment.
   */
  private static boolean isStill(Process process) {
    Path threads = Path.of("/proc", Long.toString(process.pid()), "task");
    if (!Files.isDirectory(threads)) {
      return true;
    }
    try (Stream<Path> each = Files.list(threads)) {
      for (Path thread : each.toList()) {
        String stat = Files.readString(thread.resolve("stat"));
        if (!stat.substring(stat.lastIndexOf(')')).startsWith(") T")) {
          return false;
        }
      }
      return true;
    } catch (IOException e) {
      return false;
    }
  }

  /** The process of the member; it ends when it is killed. */
  static final class Member {
    public static void main(String[] arguments) throws InterruptedException {
      PacedClock clock = new PacedClock(1);
      TestDevice device = new TestDevice("anna", clock);
      RatsMember.start(
          device.profile(),
          () -> List.of(),
          new PahoTransport(URI.create(arguments[0]), "anna", Duration.parse(arguments[1])),
          "home",
          clock);
      Thread.currentThread().join();
    }
  }
}
