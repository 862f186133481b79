package org.maestro.device.tasks;

import java.util.List;
import org.maestro.hal.Battery;
import org.maestro.hal.Completion;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.member.Execution;

/**
 * Drives to a charging station and stands there until the battery is full. On cancel it stands
 * still and charges no further.
 */
final class RechargeTask extends DeviceProcedure {

  private final Robot robot;
  private final Battery battery;

  RechargeTask(FeatureContext context) {
    this.robot = new Robot(context);
    this.battery = context.driver(Battery.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer station = parameters.pointer("station");
    Point2 place = place(station);
    execution.onCancel(
        safe -> {
          robot.stop();
          battery.stopFilling();
          safe.run();
        });
    robot.drive(
        () -> robot.routeToNearest(List.of(place)),
        () -> inTheWay(place).clause(),
        new Completion() {
          @Override
          public void done() {
            battery.fill(ending(execution));
          }

          @Override
          public void failed(String reason) {
            execution.fail(
                FeatureContext.unmet(
                    "Cannot drive to %s: %s.".formatted(station.name(), reason),
                    "clear the way",
                    List.of()));
          }
        });
  }

  private static Point2 place(Pointer station) {
    return station
        .point("referencePoint")
        .or(station::position)
        .orElseThrow(
            () ->
                new InvalidCallException(
                    "The pointer station comes without referencePoint, so that nobody finds it."))
        .floor();
  }

  @Override
  Estimate cost(CallParameters parameters) {
    Pointer station = parameters.pointer("station");
    Point2 place = place(station);
    return robot
        .routeToNearest(List.of(place))
        .map(way -> price(robot.seconds(way) + battery.secondsToFull(), robot.joules(way)))
        .orElseGet(() -> impossible(() -> inTheWay(place).sentence("to " + station.name())));
  }

  private InTheWay inTheWay(Point2 place) {
    return new InTheWay(robot, amid -> amid.routeToNearest(List.of(place)));
  }
}
