package org.maestro.junit;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.maestro.platform.MaestroPlatform;
import org.maestro.rats.time.Clock;
import org.maestro.sim.World;

/** All that runs behind a stage. Closing it leaves nothing behind. */
interface Production extends AutoCloseable {

  MaestroPlatform platform();

  Clock clock();

  World world();

  /**
   * Lets time pass until the condition holds.
   *
   * @param limit simulated time
   * @return whether it holds
   */
  boolean runUntil(BooleanSupplier condition, Duration limit);

  /** The member vanishes without goodbye, and its hardware loses power. */
  void kill(String device);

  void revive(String device);

  @Override
  void close();
}
