package org.maestro.hal.player;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.fixtures.PlayerServer;
import org.maestro.hal.Completion;
import org.maestro.hal.wheels.DifferentialWheels;
import org.maestro.hal.wheels.Stance;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.time.PacedClock;

/** A base behind Player's protocol drives as any other does (ADE, 3.3; A40). */
class PlayerBaseTest {
  private static final WheeledBase.Limits LIMITS =
      new WheeledBase.Limits(0.8, 2, 0.25, 50, 0.1, 0.1, 0.05, 0.1);

  private final PacedClock clock = new PacedClock(1);

  @AfterEach
  void close() {
    clock.close();
  }

  private WheeledBase base(PlayerConnection connection, Stance start) {
    DifferentialWheels wheels = new DifferentialWheels(0.1, 0.2);
    WheeledBase.Pace pace = this::after;
    PlayerBase player = new PlayerBase(connection, wheels, start, ahead -> true, pace);
    return new WheeledBase(wheels, player, player, pace, LIMITS);
  }

  private void after(double seconds, Runnable next) {
    clock.schedule(Duration.ofNanos(Math.round(seconds * 1e9)), "robot", next);
  }

  private static void awaitTold(PlayerConnection connection) {
    await(() -> connection.told().isPresent());
  }

  private static void await(Callable<Boolean> condition) {
    Awaitility.await().atMost(Duration.ofSeconds(30)).until(condition);
  }

  /** Empty: it is done. */
  private Optional<String> ended(Consumer<Completion> drive) {
    CompletableFuture<Optional<String>> end = new CompletableFuture<>();
    after(
        0,
        () ->
            drive.accept(
                new Completion() {
                  @Override
                  public void done() {
                    end.complete(Optional.empty());
                  }

                  @Override
                  public void failed(String reason) {
                    end.complete(Optional.of(reason));
                  }
                }));
    return end.orTimeout(60, TimeUnit.SECONDS).join();
  }

  @Test
  void drivesAndTurnsInTheHomesFrame() {
    try (PlayerServer server = new PlayerServer(100, -50, 1);
        PlayerConnection connection = PlayerConnection.open(server.address(), 0)) {
      awaitTold(connection);
      WheeledBase base = base(connection, new Stance(new Point2(3, 2), Math.PI / 2));

      assertThat(ended(done -> base.drive(List.of(new Point2(3, 3)), done))).isEmpty();
      assertThat(base.position().distance(new Point2(3, 3))).isLessThan(0.15);

      assertThat(ended(done -> base.turn(-Math.PI / 2, done))).isEmpty();
      assertThat(base.heading()).isCloseTo(0, within(0.1));
      await(() -> server.commands().get(server.commands().size() - 1).matches("-?0.00 -?0.00"));
    }
  }

  @Test
  void aBaseThatTheServerDoesNotHaveIsTold() {
    try (PlayerServer server = new PlayerServer(0, 0, 0);
        PlayerConnection connection = PlayerConnection.open(server.address(), 3)) {
      await(() -> connection.fault().orElse("").contains("no base of number 3"));
      WheeledBase base = base(connection, new Stance(new Point2(0, 0), 0));
      assertThat(ended(done -> base.drive(List.of(new Point2(1, 0)), done)).orElseThrow())
          .contains("no base of number 3");
    }
  }

  @Test
  void stalledMotorsEndTheDrive() {
    try (PlayerServer server = new PlayerServer(0, 0, 0);
        PlayerConnection connection = PlayerConnection.open(server.address(), 0)) {
      awaitTold(connection);
      WheeledBase base = base(connection, new Stance(new Point2(0, 0), 0));
      server.stall();
      assertThat(ended(done -> base.drive(List.of(new Point2(5, 0)), done)))
          .hasValue("The robot's motors are stalled.");
    }
  }

  @Test
  void whoTellsNothingAnyMoreIsNotTrusted() {
    try (PlayerServer server = new PlayerServer(0, 0, 0);
        PlayerConnection connection = PlayerConnection.open(server.address(), 0)) {
      awaitTold(connection);
      server.fallSilent();
      await(() -> connection.fault().orElse("").contains("has not told where the robot is"));
    }
  }

  @Test
  void whereTheServerBeginsAnewItGoesOnFromWhereItWas() {
    PlayerServer first = new PlayerServer(0, 0, 0);
    int port = first.address().getPort();
    try (PlayerConnection connection = PlayerConnection.open(first.address(), 0)) {
      awaitTold(connection);
      WheeledBase base = base(connection, new Stance(new Point2(1, 1), 0));
      assertThat(ended(done -> base.drive(List.of(new Point2(1.5, 1)), done))).isEmpty();
      Point2 place = base.position();
      first.close();
      await(() -> connection.told().isEmpty());
      assertThat(connection.fault().orElseThrow()).contains("does not answer");

      try (PlayerServer second = new PlayerServer(port, 7, 7, 2)) {
        awaitTold(connection);
        assertThat(base.position().distance(place)).isLessThan(0.1);
        assertThat(ended(done -> base.drive(List.of(new Point2(2, 1)), done))).isEmpty();
        assertThat(second.commands()).isNotEmpty();
      }
    }
  }
}
