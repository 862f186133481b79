package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Random;
import java.util.function.BooleanSupplier;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;

/** States come later than results that left after them, as some brokers deliver them. */
class CountedOnceLateStatesTest extends CountedOnceContract {
  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Random random = new Random(1);

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
  void aStateLeaves() {
    bus.slow(STATES, Duration.ofMillis(random.nextInt(3)));
  }

  @Override
  void await(BooleanSupplier condition) {
    assertThat(clock.runUntil(condition, Duration.ofMinutes(1))).isTrue();
  }
}
