package org.maestro.junit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.hal.MobileBase;
import org.maestro.ontology.floor.Point2;

/** Bases whose data stand with their classes, directed by the same script (ADE, 3.3; A40). */
@MaestroTest(home = "/three-drives.ttl", scene = "/three-drives-scene.ttl")
class RobotPlatformsTest {

  /**
   * @param seconds six metres at the platform's speed, and a quarter of a turn at its own
   */
  @ParameterizedTest
  @CsvSource({"dx, 6, 2.9, 0.25", "at, 14, 5.3, 0.5", "segway, 24, 8.0, 0.44"})
  void oneScriptDirectsEachOfThem(
      String robot, double x, double seconds, double radius, Stage stage) {
    Duration begun = stage.clock().now();

    assertThat(stage.goal("(corner %s)".formatted(robot))).isReached();

    Point2 place = stage.world().position(robot).orElseThrow().floor();
    assertThat(place.distance(new Point2(x, 4))).as("off by metres").isLessThan(0.1);
    assertThat(stage.clock().now().minus(begun).toMillis() / 1e3)
        .as("seconds")
        .isCloseTo(seconds, within(0.6));
    MobileBase base = stage.drivers(robot).find(MobileBase.class).orElseThrow();
    assertThat(base.radius()).isEqualTo(radius);
  }
}
