package org.maestro.hal.wheels;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.maestro.ontology.floor.Point2;

/** Odometry counts in a frame of its own; what it tells is turned into the home's. */
class DeadReckoningTest {
  private static final double QUARTER = Math.PI / 2;

  private final DeadReckoning reckoning = new DeadReckoning(stance(3, 2, QUARTER));

  private static Stance stance(double x, double y, double heading) {
    return new Stance(new Point2(x, y), heading);
  }

  private void isAt(double x, double y, double heading) {
    assertThat(reckoning.now().point().distance(new Point2(x, y))).isLessThan(1e-9);
    assertThat(reckoning.now().heading()).isCloseTo(heading, within(1e-9));
  }

  @Test
  void aMotionIsTurnedIntoTheHomesFrame() {
    reckoning.tells(stance(100, -50, 0));
    isAt(3, 2, QUARTER);
    reckoning.tells(stance(101, -50, 0));
    isAt(3, 3, QUARTER);
    reckoning.tells(stance(101, -50, -QUARTER));
    reckoning.tells(stance(101, -52, -QUARTER));
    isAt(5, 3, 0);
  }

  @Test
  void whatBeginsToCountAnewTellsNoMotion() {
    reckoning.tells(stance(100, -50, 0));
    reckoning.tells(stance(101, -50, 0));
    reckoning.beginsAnew();
    reckoning.tells(stance(0, 0, 2));
    isAt(3, 3, QUARTER);
  }

  @Test
  void fromAKnownPlaceOnItCountsFromThere() {
    reckoning.tells(stance(0, 0, 0));
    reckoning.tells(stance(1, 0, 0));
    reckoning.stands(stance(0, 0, 0));
    reckoning.tells(stance(2, 0, 0));
    isAt(1, 0, 0);
  }
}
