package org.maestro.sim;

import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.Hand;

/** Two fingers that close from both sides, in place of a jamming gripper. */
final class SimulatedFingers implements Hand {

  /** KUKA youBot data sheet: the gripper takes up to 70 mm. */
  private static final double OPENING_METRES = 0.07;

  /** Assumed; so is the following. */
  private static final double CLOSE_SECONDS = 1.5;

  private static final double LET_GO_SECONDS = 0.5;

  private final Actuator actuator;
  private final Grasp grasp;
  private final ArmMotion motion;

  SimulatedFingers(Actuator actuator, Grasp grasp, double watts) {
    this.actuator = actuator;
    this.grasp = grasp;
    this.motion = new ArmMotion(actuator, watts);
  }

  @Override
  public void open(Completion completion) {
    completion.done();
  }

  @Override
  public void close(Completion completion) {
    motion.run(CLOSE_SECONDS, completion, () -> grasp.take(this::failing));
  }

  private Optional<String> failing(Body thing) {
    Looks.Size size = actuator.world().looks().size(thing.name());
    return Math.min(size.length(), size.width()) > OPENING_METRES
        ? Optional.of("it is too large for fingers that open 7 cm")
        : Optional.empty();
  }

  @Override
  public void letGo(Completion completion) {
    motion.run(LET_GO_SECONDS, completion, grasp::putDown);
  }

  @Override
  public void stop() {
    motion.stop();
  }

  @Override
  public double closeSeconds() {
    return CLOSE_SECONDS;
  }

  @Override
  public double letGoSeconds() {
    return LET_GO_SECONDS;
  }
}
