package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.device.navigation.Route;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;

/**
 * Why a robot finds no free way: what stands in it. It is searched for only once no way was found,
 * and the robot tells of it from then on.
 */
final class InTheWay {

  private final Robot robot;
  private final Function<Robot, Optional<Route>> plan;

  /**
   * @param plan the way of such a robot, which found none amid all that stands there
   */
  InTheWay(Robot robot, Function<Robot, Optional<Route>> plan) {
    this.robot = robot;
    this.plan = plan;
  }

  /** A sentence without its full stop. */
  String sentence(String whither) {
    return "There is no free way " + whither + reason();
  }

  /** The same as a part of a sentence. */
  String clause() {
    return "there is no free way" + reason();
  }

  private String reason() {
    List<String> names = bars().stream().map(Obstacle::name).toList();
    robot.barredBy(names);
    if (names.isEmpty()) {
      return "";
    }
    int last = names.size() - 1;
    return last == 0
        ? ": " + names.get(0) + " stands in it"
        : ": "
            + String.join(", ", names.subList(0, last))
            + " and "
            + names.get(last)
            + " stand in it";
  }

  /**
   * What stands on the way that there would be on an empty floor, without those that need not go:
   * without all of these there is a way, and none as long as any one of them stands there. Empty
   * when walls bar it, or when a way around these would be barred elsewhere.
   */
  List<Obstacle> bars() {
    Optional<Route> direct = plan.apply(robot.amid(List.of()));
    if (direct.isEmpty()) {
      return List.of();
    }
    List<Obstacle> rest = new ArrayList<>(robot.surroundings().inView().obstacles());
    List<Obstacle> bars =
        new ArrayList<>(rest.stream().filter(body -> isOn(direct.get(), body)).toList());
    rest.removeAll(bars);
    if (!isReached(rest)) {
      return List.of();
    }
    for (Obstacle body : List.copyOf(bars)) {
      rest.add(body);
      if (bars.size() > 1 && isReached(rest)) {
        bars.remove(body);
      } else {
        rest.remove(body);
      }
    }
    return List.copyOf(bars);
  }

  private boolean isReached(List<Obstacle> obstacles) {
    return plan.apply(robot.amid(obstacles)).isPresent();
  }

  private boolean isOn(Route route, Obstacle body) {
    RoutePlanner alone =
        new RoutePlanner(new WalledFloor(List.of(), robot.base().radius()), List.of(body));
    Point2 from = robot.base().position();
    for (Point2 corner : route.way()) {
      if (!alone.isFree(corner) || !alone.isFreeWay(from, corner)) {
        return true;
      }
      from = corner;
    }
    return false;
  }
}
