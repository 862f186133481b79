package org.maestro.sim.drivers;

import java.util.Optional;
import org.maestro.hal.Completion;

/**
 * The commands of one motor of an arm: one at a time, each of which takes its time and power and
 * fails when the device is defect.
 */
final class ArmMotion {

  private final Actuator actuator;
  private final double watts;
  private long number;

  ArmMotion(Actuator actuator, double watts) {
    this.actuator = actuator;
    this.watts = watts;
  }

  /** Ends what runs; its completion is not told. */
  void stop() {
    number++;
  }

  /**
   * @param effect why it failed, empty when it did not
   */
  void run(double seconds, Completion completion, Effect effect) {
    long begun = ++number;
    actuator.world().batteries().draw(actuator.device(), seconds * watts);
    actuator.after(
        seconds,
        () -> {
          if (begun == number) {
            Optional<String> failure =
                actuator.world().faults().defect(actuator.device()).or(effect::happens);
            if (failure.isPresent()) {
              completion.failed(failure.get());
            } else if (actuator.world().isAlive(actuator.device())) {
              completion.done();
            }
          }
        });
  }

  interface Effect {
    Optional<String> happens();
  }
}
