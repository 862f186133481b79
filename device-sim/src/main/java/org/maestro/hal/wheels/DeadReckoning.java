package org.maestro.hal.wheels;

import java.util.Optional;

/**
 * Where a base is by its odometry, from where it was known to stand: odometry tells each motion,
 * and begins to count wherever it likes. Clock thread only.
 */
public final class DeadReckoning {

  private Stance now;
  private Optional<Stance> counted = Optional.empty();

  public DeadReckoning(Stance start) {
    this.now = start;
  }

  public Stance now() {
    return now;
  }

  /** Odometry tells this now; the first time it tells no motion. */
  public void tells(Stance odometry) {
    counted.ifPresent(before -> now = moved(before, odometry));
    counted = Optional.of(odometry);
  }

  private Stance moved(Stance before, Stance odometry) {
    double turned = now.heading() - before.heading();
    double x = odometry.point().x() - before.point().x();
    double y = odometry.point().y() - before.point().y();
    return new Stance(
        now.point()
            .plus(
                x * Math.cos(turned) - y * Math.sin(turned),
                x * Math.sin(turned) + y * Math.cos(turned)),
        odometry.heading() + turned);
  }

  /** Odometry has begun to count anew; meanwhile the base has stood still. */
  public void beginsAnew() {
    counted = Optional.empty();
  }

  /** It is known otherwise where the base stands now. */
  public void stands(Stance known) {
    now = known;
  }
}
