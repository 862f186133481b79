package org.maestro.members;

import java.time.Duration;
import java.util.Random;

/** States come later than results that left after them, as some brokers deliver them. */
class CountedOnceLateStatesTest extends CountedOnceInProcessTest {
  private final Random random = new Random(1);

  @Override
  void aStateLeaves() {
    bus.slow(STATES, Duration.ofMillis(random.nextInt(3)));
  }
}
