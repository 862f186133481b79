package org.maestro.sim.drivers;

import java.util.Locale;
import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.Hand;
import org.maestro.hal.sight.Size;
import org.maestro.sim.world.Body;

/** Two fingers that close from both sides, in place of a jamming gripper. */
final class SimulatedFingers implements Hand {

  /** KUKA youBot data sheet: the gripper takes up to 70 mm. */
  static final double USUAL_OPENING_METRES = 0.07;

  private static final double CENTIMETRES = 100;

  /** Time of the fingers to close; assumed. */
  private static final double CLOSE_SECONDS = 1.5;

  /** Time of the fingers to open; assumed. */
  private static final double LET_GO_SECONDS = 0.5;

  private final Actuator actuator;
  private final Grasp grasp;
  private final ArmMotion motion;
  private final double opening;

  SimulatedFingers(Actuator actuator, Grasp grasp, double watts, double opening) {
    this.actuator = actuator;
    this.grasp = grasp;
    this.motion = new ArmMotion(actuator, watts);
    this.opening = opening;
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
    Size size = actuator.world().looks().size(thing.name());
    return Math.min(size.length(), size.width()) > opening
        ? Optional.of(
            String.format(
                Locale.ROOT,
                "it is too large for fingers that open %.0f cm",
                CENTIMETRES * opening))
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
  public double opening() {
    return opening;
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
