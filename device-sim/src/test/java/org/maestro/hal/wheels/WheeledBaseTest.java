package org.maestro.hal.wheels;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.hal.Completion;
import org.maestro.hal.Localization;
import org.maestro.hal.Twist;
import org.maestro.hal.WheelMotors;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** A base whose commands come late, as on a machine that does other things. */
class WheeledBaseTest {
  private static final DifferentialWheels WHEELS = new DifferentialWheels(0.05, 0.2);
  private static final double LATEST_SECONDS = 0.05;

  private final Deque<Runnable> due = new ArrayDeque<>();
  private final Random lateness = new Random(1);
  private Twist motion = Twist.STILL;
  private double heading;
  private double seconds;
  private boolean done;

  private final WheeledBase base =
      new WheeledBase(
          WHEELS,
          new WheelMotors() {
            @Override
            public void spin(List<Double> radiansPerSecond) {
              motion = WHEELS.motion(radiansPerSecond);
            }

            @Override
            public Optional<String> fault() {
              return Optional.empty();
            }
          },
          new Localization() {
            @Override
            public Point2 position() {
              return new Point2(0, 0);
            }

            @Override
            public double heading() {
              return heading;
            }

            @Override
            public boolean isFree(Segment ahead) {
              return true;
            }
          },
          this::later,
          new WheeledBase.Limits(0.7, Math.PI / 2, 0.3, 80, 0.1, 0, 0.01, 0.05));

  private void later(double after, Runnable next) {
    double late = after == 0 ? 0 : after + LATEST_SECONDS * lateness.nextDouble();
    due.add(
        () -> {
          heading += motion.turn() * late;
          seconds += late;
          next.run();
        });
  }

  @ParameterizedTest
  @ValueSource(doubles = {90, -30, 180, -400, 3})
  void itTurnsAsFarAsItIsToldThoughItsCommandsComeLate(double degrees) {
    base.turn(
        Math.toRadians(degrees),
        new Completion() {
          @Override
          public void done() {
            done = true;
          }

          @Override
          public void failed(String reason) {
            throw new AssertionError(reason);
          }
        });
    while (!due.isEmpty()) {
      due.remove().run();
    }

    assertThat(done).isTrue();
    assertThat(Math.toDegrees(heading)).isCloseTo(degrees, within(0.1));
    assertThat(seconds).isLessThan(Math.abs(degrees) / 90 * 1.6 + 2);
    assertThat(motion).isEqualTo(Twist.STILL);
  }
}
