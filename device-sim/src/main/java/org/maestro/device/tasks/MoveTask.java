package org.maestro.device.tasks;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.hal.Area;
import org.maestro.hal.Completion;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;

/**
 * Drives to the nearest point of an area at which the robot stands wholly in it; when it is told
 * where it goes from there, to the first such point on the shortest way there. On cancel it stands
 * still, which is safe.
 */
final class MoveTask extends DeviceProcedure {

  /** Even where nothing is to be driven, a call takes its time. */
  private static final double LEAST_SECONDS = 0.5;

  private final FeatureContext context;
  private final Robot robot;

  MoveTask(FeatureContext context) {
    this.context = context;
    this.robot = new Robot(context);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Area area = robot.area(parameters.pointer("to"));
    List<Point2> goals = robot.standsIn(area);
    Optional<Point2> onward = parameters.optionalPosition("onward").map(Position::floor);
    execution.onCancel(
        safe -> {
          robot.stop();
          safe.run();
        });
    robot.drive(
        () ->
            onward
                .flatMap(place -> robot.routeInto(area, place))
                .or(() -> robot.routeToNearest(goals)),
        () -> new InTheWay(robot, amid -> amid.routeToNearest(goals)).clause(),
        new Completion() {
          @Override
          public void done() {
            execution.succeed(Map.of());
          }

          @Override
          public void failed(String reason) {
            execution.fail(blocked(parameters, reason));
          }
        });
  }

  private RatsError blocked(CallParameters parameters, String reason) {
    String message = "Cannot drive to " + parameters.pointer("to").name() + ": " + reason + ".";
    boolean named = parameters.optionalPointer("from").isPresent();
    return FeatureContext.unmet(
        message,
        "open a door or clear the way",
        named
            ? context.reference("passable", parameters, Map.of(), "true", false).stream().toList()
            : List.of());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return costFrom(start(parameters), parameters);
  }

  @Override
  Estimate costFromNow(CallParameters parameters) {
    return costFrom(robot.base().position(), parameters);
  }

  private Estimate costFrom(Point2 start, CallParameters parameters) {
    List<Point2> goals = robot.standsIn(robot.area(parameters.pointer("to")));
    return robot
        .route(start, goals)
        .map(way -> price(Math.max(LEAST_SECONDS, robot.seconds(way)), robot.joules(way)))
        .orElseGet(
            () ->
                impossible(
                    () ->
                        new InTheWay(robot, amid -> amid.route(start, goals))
                            .sentence("to " + parameters.pointer("to").name())));
  }

  /**
   * Where the robot is, or, where a plan has it drive from elsewhere, the stand there to which it
   * has least to go: what leads there is a step of its own, with its own price.
   */
  private Point2 start(CallParameters parameters) {
    Point2 here = robot.base().position();
    return parameters
        .optionalPointer("from")
        .flatMap(from -> robot.area(from.name()))
        .filter(area -> !area.outline().contains(here))
        .flatMap(
            area ->
                robot.standsIn(area).stream()
                    .min(Comparator.comparingDouble(stand -> stand.distance(here))))
        .orElse(here);
  }
}
