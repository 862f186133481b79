package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.maestro.rats.broker.TestBroker;
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

  static void assertNoThreadIsLeft() {
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
    return new PahoTransport(broker().uri(), id);
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
