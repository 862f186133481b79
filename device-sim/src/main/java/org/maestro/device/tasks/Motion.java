package org.maestro.device.tasks;

import java.util.Optional;

/**
 * What a robot's base is at, so that it can be ended from beside: whoever is told to stand still
 * knows nothing of the feature that has it drive. Shared by the features of a device. Clock thread
 * only.
 */
public final class Motion {
  private Optional<Runnable> halting = Optional.empty();

  /**
   * It has begun.
   *
   * @param halted to be run once, if it is ended before it is over
   */
  void begin(Runnable halted) {
    halting = Optional.of(halted);
  }

  /** It is over by itself, or was cancelled. */
  void over() {
    halting = Optional.empty();
  }

  /** Ends what is under way, if anything is. */
  void halt() {
    Optional<Runnable> halted = halting;
    halting = Optional.empty();
    halted.ifPresent(Runnable::run);
  }
}
