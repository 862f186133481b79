package org.maestro.device.tasks;

import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.hal.Completion;
import org.maestro.hal.Steering;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;

/**
 * Drives a robot straight ahead: as far as it is told, or until it is told to stand still. Before
 * what stands in its way it stands still by itself, and says so. On cancel it stands still.
 */
final class DriveTask extends DeviceProcedure {

  /** Nobody who says no distance means more than this. */
  private static final double FARTHEST_METRES = 1000;

  /** So far it looks ahead once it stands, to see whether it was that which kept it. */
  private static final double AHEAD_METRES = 0.25;

  private final FeatureContext context;
  private final Robot robot;
  private final Steering steering;

  DriveTask(FeatureContext context) {
    this.context = context;
    this.robot = new Robot(context);
    this.steering = context.driver(Steering.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    OptionalDouble wanted = metres(parameters);
    Point2 from = robot.base().position();
    execution.onCancel(
        safe -> {
          robot.stop();
          safe.run();
        });
    robot.driveStraight(
        ahead(wanted.orElse(FARTHEST_METRES)),
        () -> halted(execution, wanted, from),
        new Completion() {
          @Override
          public void done() {
            execution.succeed(values(from, false));
          }

          @Override
          public void failed(String reason) {
            if (robot.isFreeTo(ahead(AHEAD_METRES))) {
              execution.fail(FeatureContext.broken(reason));
            } else if (wanted.isPresent()) {
              execution.fail(blocked(from, parameters));
            } else {
              execution.succeed(values(from, true));
            }
          }
        });
  }

  /** Who has not said how far is told that it went as it was told. */
  private void halted(Execution execution, OptionalDouble wanted, Point2 from) {
    if (wanted.isPresent()) {
      execution.fail(
          FeatureContext.broken(
              "It was told to stand still after %s m.".formatted(Numbers.plain(driven(from)))));
    } else {
      execution.succeed(values(from, false));
    }
  }

  private RatsError blocked(Point2 from, CallParameters parameters) {
    return FeatureContext.unmet(
        "Something stands in the way after %s m.".formatted(Numbers.plain(driven(from))),
        "turn to where the way is free",
        context.reference("blocked", parameters, Map.of(), "false", true).stream().toList());
  }

  private Map<String, Object> values(Point2 from, boolean blocked) {
    return Map.of("driven", driven(from), "blocked", blocked);
  }

  private double driven(Point2 from) {
    return Numbers.tenths(from.distance(robot.base().position()));
  }

  private Point2 ahead(double metres) {
    return robot
        .base()
        .position()
        .plus(metres * Math.cos(steering.heading()), metres * Math.sin(steering.heading()));
  }

  private static OptionalDouble metres(CallParameters parameters) {
    OptionalDouble metres = parameters.optionalNumber("metres");
    if (metres.isPresent()
        && !(metres.getAsDouble() > 0 && metres.getAsDouble() <= FARTHEST_METRES)) {
      throw new InvalidCallException(
          "The parameter metres is more than 0 and %s at most, but is %s."
              .formatted(Numbers.plain(FARTHEST_METRES), Numbers.plain(metres.getAsDouble())));
    }
    return metres;
  }

  /** Of a way without an end nobody knows more than what it costs to set off. */
  @Override
  Estimate cost(CallParameters parameters) {
    double seconds = metres(parameters).orElse(0) / robot.base().speed();
    return price(seconds, seconds * robot.base().power());
  }
}
