package org.maestro.hal.wheels;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.hal.Twist;

class WheelGeometryTest {

  /** A KUKA youBot's. */
  private static final MecanumWheels MECANUM = new MecanumWheels(0.0475, 0.2355, 0.15);

  private static final DifferentialWheels TWO = new DifferentialWheels(0.05, 0.2);

  @ParameterizedTest
  @CsvSource({
    // 0.475 m/s are ten radians a second; a turn of 1 rad/s is 0.3855 m/s at each wheel
    "0.475, 0, 0, 10, 10, 10, 10",
    "0, 0.475, 0, -10, 10, 10, -10",
    "0, 0, 1, -8.11579, 8.11579, -8.11579, 8.11579",
    "0.475, 0.475, 0, 0, 20, 20, 0",
    "0.475, -0.475, 1, 11.88421, 8.11579, -8.11579, 28.11579"
  })
  void mecanumWheelsTurnAsTheMotionAsks(
      double forward, double left, double turn, double fl, double fr, double rl, double rr) {
    List<Double> speeds = MECANUM.wheelSpeeds(new Twist(forward, left, turn));
    double[] expected = {fl, fr, rl, rr};
    for (int i = 0; i < expected.length; i++) {
      assertThat(speeds.get(i)).isCloseTo(expected[i], within(1e-4));
    }
  }

  @Test
  void theForwardModelGivesBackEveryMotion() {
    for (double forward = -0.8; forward <= 0.8; forward += 0.4) {
      for (double left = -0.8; left <= 0.8; left += 0.4) {
        for (double turn = -1.5; turn <= 1.5; turn += 0.5) {
          assertSame(
              MECANUM.motion(MECANUM.wheelSpeeds(new Twist(forward, left, turn))),
              new Twist(forward, left, turn));
          assertSame(
              TWO.motion(TWO.wheelSpeeds(new Twist(forward, 0, turn))),
              new Twist(forward, 0, turn));
        }
      }
    }
  }

  private static void assertSame(Twist actual, Twist expected) {
    assertThat(actual.forward()).isCloseTo(expected.forward(), within(1e-12));
    assertThat(actual.left()).isCloseTo(expected.left(), within(1e-12));
    assertThat(actual.turn()).isCloseTo(expected.turn(), within(1e-12));
  }

  @Test
  void oneSlippingWheelTurnsAndShiftsTheBase() {
    // the front left wheel lacks a quarter of what carries it forward
    Twist slipped = MECANUM.motion(List.of(0.0, 10.0, 10.0, 10.0));
    assertThat(slipped.forward()).isCloseTo(0.75 * 0.475, within(1e-9));
    assertThat(slipped.left()).isCloseTo(0.25 * 0.475, within(1e-9));
    assertThat(slipped.turn()).isCloseTo(0.25 * 0.475 / 0.3855, within(1e-9));
  }

  @Test
  void twoWheelsDoNotDriveToTheSide() {
    assertThat(TWO.wheelSpeeds(new Twist(0.5, 0, 1)))
        .allMatch(speed -> Math.abs(Math.abs(speed - 10) - 4) < 1e-9);
    assertThatIllegalArgumentException()
        .isThrownBy(() -> TWO.wheelSpeeds(new Twist(0.5, 0.1, 0)))
        .withMessageContaining("turn first");
  }
}
