package org.maestro.sim.drivers;

import java.time.Duration;
import org.maestro.hal.WallClock;
import org.maestro.sim.scene.WorldEvent;

/** A clock that is right, and tells each minute when it begins. */
final class SimulatedWallClock implements WallClock {

  private static final Duration DAY = Duration.ofDays(1);
  private static final Duration MINUTE = Duration.ofMinutes(1);

  private final Actuator actuator;
  private final Duration startedAt;

  private SimulatedWallClock(Actuator actuator, Duration startedAt) {
    this.actuator = actuator;
    this.startedAt = startedAt;
  }

  /**
   * A clock that goes from now on.
   *
   * @param startedAt the time of day when simulated time began
   */
  static SimulatedWallClock start(Actuator actuator, Duration startedAt) {
    SimulatedWallClock clock = new SimulatedWallClock(actuator, startedAt);
    clock.goOn();
    return clock;
  }

  private void goOn() {
    Duration shown = Duration.ofMinutes(time().toMinutes());
    actuator.afterInAnyCase(shown.plus(MINUTE).minus(time()).toMillis() / 1e3, this::strike);
  }

  private void strike() {
    if (actuator.world().isAlive(actuator.device())) {
      actuator.tell(WorldEvent.Kind.MEASURED);
    }
    goOn();
  }

  private Duration time() {
    return startedAt.plus(actuator.clock().now());
  }

  @Override
  public int minuteOfDay() {
    return (int) (time().toMinutes() % DAY.toMinutes());
  }
}
