package org.maestro.hal;

import java.util.List;
import java.util.Optional;

/** The motors of a base's wheels. Without a new command they stand still after a second. */
public interface WheelMotors {

  /**
   * @param radiansPerSecond of each wheel, positive forwards, in the order of the base's {@link
   *     org.maestro.hal.wheels.WheelGeometry}
   */
  void spin(List<Double> radiansPerSecond);

  /** Why they do not turn, one sentence for people; empty when they can. */
  Optional<String> fault();
}
