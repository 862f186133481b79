package org.maestro.device.tasks;

import java.util.Optional;
import org.maestro.hal.Position;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;

/**
 * A body beside which something is to be put: who calls tells where it is, and the robot follows
 * with its own eyes whatever stands there. Which body that is its eyes do not tell. Clock thread
 * only.
 */
final class FollowedBody {

  /** A body that is seen so far from where one is told to be is that one; metres. */
  private static final double SAME_METRES = 0.3;

  private final Robot robot;
  private Position place;
  private Optional<String> seen = Optional.empty();

  /**
   * @param told where it is
   */
  FollowedBody(Robot robot, Position told) {
    this.robot = robot;
    this.place = told;
  }

  /** Where it is seen, or was seen last, or is told to be. */
  Position place() {
    Optional<Obstacle> now = look();
    now.ifPresent(body -> place = Position.onFloor(body.middle()));
    seen = now.map(Obstacle::name).or(() -> seen);
    return place;
  }

  private Optional<Obstacle> look() {
    return seen.isPresent() ? robot.seen(seen.get()) : robot.seenAt(place.floor(), SAME_METRES);
  }

  /** Whether it would be seen where it was, and is not. */
  boolean isGone() {
    Point2 before = place().floor();
    return look().isEmpty() && robot.surroundings().sees(Position.onFloor(before));
  }
}
