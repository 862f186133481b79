package org.maestro.members;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Transport;

class CountedOnceOverMqttTest extends CountedOnceContract {
  private final EmbeddedBroker broker = EmbeddedBroker.start();
  private final PacedClock clock = new PacedClock(1);

  @AfterEach
  void stop() {
    clock.close();
    broker.close();
  }

  @Override
  int usualSeeds() {
    return 100;
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
  void await(BooleanSupplier condition) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(1))
        .atMost(Duration.ofSeconds(60))
        .until(condition::getAsBoolean);
  }
}
