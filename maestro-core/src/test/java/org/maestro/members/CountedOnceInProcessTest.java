package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;

class CountedOnceInProcessTest extends CountedOnceContract {
  private final SteppedClock clock = new SteppedClock();
  final InProcessBus bus = new InProcessBus(clock);

  @Override
  int usualSeeds() {
    return MOST_SEEDS;
  }

  @Override
  Clock clock() {
    return clock;
  }

  @Override
  Transport client(String id) {
    return bus.client(id);
  }

  @Override
  void await(BooleanSupplier condition) {
    assertThat(clock.runUntil(condition, Duration.ofMinutes(1))).isTrue();
  }
}
