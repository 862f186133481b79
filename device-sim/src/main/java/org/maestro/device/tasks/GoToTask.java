package org.maestro.device.tasks;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.device.navigation.Route;
import org.maestro.hal.Completion;
import org.maestro.hal.Steering;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;

/**
 * Drives a robot to a position of the floor, on the shortest way that is free, and then turns it
 * until its front looks where it is told. On cancel it stands still.
 */
final class GoToTask extends DeviceProcedure {
  private final Robot robot;
  private final Steering steering;
  private final Motion motion;

  GoToTask(FeatureContext context) {
    this.robot = new Robot(context);
    this.steering = context.driver(Steering.class);
    this.motion = context.motion();
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Point2 place = place(parameters);
    OptionalDouble heading = parameters.optionalNumber("heading");
    execution.onCancel(
        safe -> {
          robot.stop();
          safe.run();
        });
    robot.drive(
        () -> way(robot, place),
        () -> new InTheWay(robot, amid -> way(amid, place)).clause(),
        new Completion() {
          @Override
          public void done() {
            if (heading.isPresent()) {
              turn(execution, heading.getAsDouble());
            } else {
              arrived(execution);
            }
          }

          @Override
          public void failed(String reason) {
            execution.fail(
                FeatureContext.unmet(
                    "Cannot drive to %s: %s.".formatted(text(place), reason),
                    "open a door or clear the way",
                    List.of()));
          }
        });
  }

  private void turn(Execution execution, double degrees) {
    motion.begin(
        () ->
            execution.fail(
                FeatureContext.broken(
                    "It was told to stand still while it turned; its front looks to %s degrees."
                        .formatted(Numbers.plain(Numbers.degreesAround(steering.heading()))))));
    steering.turn(
        toTurn(degrees),
        new Completion() {
          @Override
          public void done() {
            motion.over();
            arrived(execution);
          }

          @Override
          public void failed(String reason) {
            motion.over();
            execution.fail(FeatureContext.broken(reason));
          }
        });
  }

  private void arrived(Execution execution) {
    Point2 here = robot.base().position();
    execution.succeed(
        Map.of(
            "reachedX",
            Numbers.tenths(here.x()),
            "reachedY",
            Numbers.tenths(here.y()),
            "facing",
            Numbers.degreesAround(steering.heading())));
  }

  /** The shorter way round; radians. */
  private double toTurn(double degrees) {
    return Math.IEEEremainder(Math.toRadians(degrees) - steering.heading(), 2 * Math.PI);
  }

  private Point2 place(CallParameters parameters) {
    Point2 place = new Point2(parameters.number("x"), parameters.number("y"));
    if (!robot.isOnMap(place)) {
      throw new InvalidCallException(
          "The position %s is in none of the places that are on the map.".formatted(text(place)));
    }
    return place;
  }

  private static Optional<Route> way(Robot robot, Point2 place) {
    return robot.routeToNearest(List.of(place));
  }

  private static String text(Point2 place) {
    return "(%s, %s)".formatted(Numbers.plain(place.x()), Numbers.plain(place.y()));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    Point2 place = place(parameters);
    return way(robot, place)
        .map(
            way -> {
              OptionalDouble heading = parameters.optionalNumber("heading");
              // Where it will look when it gets there is known on the way alone: half a turn at
              // most.
              double turning = heading.isPresent() ? Math.PI / 2 / steering.turnSpeed() : 0;
              double seconds = robot.seconds(way) + turning;
              return price(seconds, seconds * robot.base().power());
            })
        .orElseGet(
            () ->
                impossible(
                    () ->
                        new InTheWay(robot, amid -> way(amid, place))
                            .sentence("to " + text(place))));
  }
}
