package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;

class PahoLinkTest extends LinkContract {

  private static final double SPEED = 20;
  private static EmbeddedBroker broker;

  private final PacedClock clock = new PacedClock(SPEED);

  @BeforeAll
  static void startBroker() {
    broker = EmbeddedBroker.start();
  }

  @AfterEach
  void closeClock() {
    clock.close();
  }

  @AfterAll
  static void leavesNoThread() {
    broker.close();
    Awaitility.await()
        .atMost(Duration.ofSeconds(5))
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces().keySet())
                    .extracting(Thread::getName)
                    .noneMatch(
                        name ->
                            name.startsWith("rats-")
                                || name.startsWith("maestro-")
                                || name.contains("MQTT")));
  }

  @Override
  Clock clock() {
    return clock;
  }

  @Override
  Transport client(String id) {
    return new PahoTransport(broker.uri(), id);
  }

  @Override
  void stopBroker() {
    broker.close();
  }

  @Override
  void restartBroker() {
    broker = EmbeddedBroker.start(broker.uri().getPort());
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
