package org.maestro.device.tasks;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.hal.Completion;
import org.maestro.hal.GripperArm;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;

/** The common part of picking and placing: the robot, its arm, and the way out on cancel. */
abstract class ArmTask extends DeviceProcedure {

  private final FeatureContext context;
  private final Robot robot;
  private final GripperArm arm;
  private final Reach reach;

  ArmTask(FeatureContext context) {
    this.context = context;
    this.robot = new Robot(context);
    this.arm = context.driver(GripperArm.class);
    this.reach = new Reach(robot, arm.reach());
  }

  final FeatureContext context() {
    return context;
  }

  final Robot robot() {
    return robot;
  }

  final GripperArm arm() {
    return arm;
  }

  /**
   * @param plan where to go, asked again when something came in the way
   * @param chosen told the spot that will be reached
   */
  final ActionSequence.Action approach(
      Function<Reach, Optional<Reach.Approach>> plan, Consumer<Point2> chosen, String doing) {
    return new ActionSequence.Action(
        "approach",
        completion ->
            robot.drive(
                () -> {
                  Optional<Reach.Approach> approach = plan.apply(reach);
                  approach.ifPresent(found -> chosen.accept(found.spot()));
                  return approach.map(Reach.Approach::route);
                },
                inTheWay(plan)::clause,
                completion),
        reason -> unreachable(doing + ": " + reason + "."));
  }

  static RatsError unreachable(String message) {
    return FeatureContext.unmet(message, "clear the way", List.of());
  }

  /** The price of a task of the arm, with what of the way counts for it. */
  final Estimate price(
      Function<Reach, Optional<Reach.Approach>> plan, double armSeconds, String doing) {
    Optional<Reach.Approach> approach = plan.apply(reach);
    if (approach.isEmpty()) {
      return impossible(() -> inTheWay(plan).sentence("for " + doing));
    }
    double metres = Math.min(approach.get().route().length(), Prices.LONGEST_APPROACH_METRES);
    double driving = metres / robot.base().speed();
    return price(driving + armSeconds, driving * robot.base().power() + armSeconds * arm.power());
  }

  private InTheWay inTheWay(Function<Reach, Optional<Reach.Approach>> plan) {
    return new InTheWay(
        robot, amid -> plan.apply(new Reach(amid, arm.reach())).map(Reach.Approach::route));
  }

  final Estimate price(double armSeconds) {
    return price(armSeconds, armSeconds * arm.power());
  }

  /**
   * Exit strategy (Three-layered architecture, 3.2.1; M45): stand still, put down what is held if
   * there is a free spot, fold the arm.
   */
  final void exitSafely(Execution execution) {
    execution.onCancel(
        safe -> {
          robot.stop();
          Optional<Point2> spot = arm.held().flatMap(held -> reach.here());
          if (spot.isPresent()) {
            arm.extend(Position.onFloor(spot.get()), then(() -> letGo(safe), safe));
          } else {
            arm.fold(then(safe, safe));
          }
        });
  }

  private void letGo(Runnable safe) {
    arm.release(then(() -> arm.fold(then(safe, safe)), safe));
  }

  private static Completion then(Runnable next, Runnable otherwise) {
    return new Completion() {
      @Override
      public void done() {
        next.run();
      }

      @Override
      public void failed(String reason) {
        otherwise.run();
      }
    };
  }
}
