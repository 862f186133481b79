package org.maestro.hal.ros;

import java.time.Duration;
import java.util.Optional;
import org.maestro.hal.Twist;
import org.maestro.hal.wheels.Stance;

/**
 * Whether a base that is told to move does: ROS has no word for motors that are stalled or switched
 * off, so that only its odometry shows it. Clock thread only.
 */
final class Striving {

  /** So long a base may take to begin; assumed. */
  private static final Duration BEGINS_WITHIN = Duration.ofSeconds(3);

  /** Less than this is no motion; odometry trembles by less. */
  private static final double METRES = 0.01;

  private static final double RADIANS = 0.01;

  private boolean isToMove;
  private Optional<Since> since = Optional.empty();

  /** Where it was when it began, or moved last. */
  private record Since(Stance place, long atNanos) {}

  void told(Twist motion) {
    isToMove = !motion.equals(Twist.STILL);
    if (!isToMove) {
      since = Optional.empty();
    }
  }

  /**
   * Why it does not move, one sentence for people; empty when it does, or need not.
   *
   * @param place by its odometry
   */
  Optional<String> inVain(Stance place, long atNanos) {
    if (!isToMove) {
      return Optional.empty();
    }
    if (since.filter(then -> hasNotMoved(then.place(), place)).isEmpty()) {
      since = Optional.of(new Since(place, atNanos));
    }
    return since
        .filter(then -> atNanos - then.atNanos() > BEGINS_WITHIN.toNanos())
        .map(
            then ->
                "The robot has been told to move for more than %d s, and its odometry says that it stands still."
                    .formatted(BEGINS_WITHIN.toSeconds()));
  }

  private static boolean hasNotMoved(Stance then, Stance now) {
    return then.point().distance(now.point()) < METRES
        && Math.abs(Math.IEEEremainder(now.heading() - then.heading(), 2 * Math.PI)) < RADIANS;
  }
}
