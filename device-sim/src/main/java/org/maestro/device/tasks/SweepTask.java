package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.device.navigation.Route;
import org.maestro.hal.Completion;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;

/**
 * Drives over a zone in lanes, with what sweeps beneath it. Where something stands it does not
 * sweep. On cancel it stands still.
 */
final class SweepTask extends DeviceProcedure {

  private final FeatureContext context;
  private final Robot robot;

  SweepTask(FeatureContext context) {
    this.context = context;
    this.robot = new Robot(context);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer zone = parameters.pointer("zone");
    execution.onCancel(
        safe -> {
          robot.stop();
          safe.run();
        });
    List<ActionSequence.Action> lanes = new ArrayList<>();
    for (Point2 end : robot.lanes(robot.area(zone))) {
      lanes.add(
          new ActionSequence.Action(
              "drive to " + end,
              completion -> drive(end, completion),
              reason ->
                  FeatureContext.unmet(
                      "Cannot sweep %s: %s.".formatted(zone.name(), reason),
                      "clear the way",
                      List.of())));
    }
    if (lanes.isEmpty()) {
      execution.fail(FeatureContext.unmet(noRoom(zone), "clear the floor", List.of()));
      return;
    }
    new ActionSequence(context.device(), execution, lanes, () -> execution.succeed(Map.of())).run();
  }

  private void drive(Point2 end, Completion completion) {
    List<Point2> goal = List.of(end);
    robot.drive(
        () -> robot.routeToNearest(goal),
        () -> new InTheWay(robot, amid -> amid.routeToNearest(goal)).clause(),
        completion);
  }

  private static String noRoom(Pointer zone) {
    return "There is no room in %s for its base to sweep.".formatted(zone.name());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    Pointer zone = parameters.pointer("zone");
    double seconds = 0;
    double joules = 0;
    Point2 at = robot.base().position();
    List<Point2> ends = robot.lanes(robot.area(zone));
    for (Point2 end : ends) {
      Optional<Route> way = robot.route(at, List.of(end));
      if (way.isPresent()) {
        seconds += robot.seconds(way.get());
        joules += robot.joules(way.get());
        at = end;
      }
    }
    return ends.isEmpty() ? impossible(() -> noRoom(zone)) : price(seconds, joules);
  }
}
