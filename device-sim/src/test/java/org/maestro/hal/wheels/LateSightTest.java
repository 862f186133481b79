package org.maestro.hal.wheels;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.hal.Completion;
import org.maestro.hal.Localization;
import org.maestro.hal.Twist;
import org.maestro.hal.WheelMotors;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** A base that hears where it is some time after it was there, as behind a robot's server. */
class LateSightTest {
  private static final DifferentialWheels WHEELS = new DifferentialWheels(1, 1);
  private static final double STEP_SECONDS = 0.01;

  private final Deque<Stance> seen = new ArrayDeque<>(List.of(new Stance(new Point2(0, 0), 0)));
  private Stance place = seen.getFirst();
  private Twist motion = Twist.STILL;
  private Runnable next = () -> {};
  private double nextAt;
  private double now;
  private boolean done;

  @ParameterizedTest
  @CsvSource({
    "0.05, 1.2, 300",
    "0.1, 1.2, 300",
    "0.1, 2.2, 500",
    "0.1, 0.4, 45",
    "0, 1.2, 300",
  })
  void itGetsWhereItIsSentAndLooksWhereItIsTurned(
      double delaySeconds, double metresPerSecond, double degreesPerSecond) {
    WheeledBase base = base(metresPerSecond, Math.toRadians(degreesPerSecond));
    Point2 there = new Point2(-1, 2);

    base.drive(List.of(new Point2(1, 1), there), completion());
    pass(delaySeconds);

    assertThat(done).isTrue();
    assertThat(place.point().distance(there)).as("metres beside").isLessThan(0.2);
    done = false;
    double before = place.heading();
    base.turn(Math.PI / 2, completion());
    pass(delaySeconds);

    assertThat(done).isTrue();
    assertThat(Math.abs(place.heading() - before - Math.PI / 2)).isLessThan(0.05);
    assertThat(motion).isEqualTo(Twist.STILL);
  }

  /** Twenty seconds at most. */
  private void pass(double delaySeconds) {
    double end = now + 20;
    while (!done && now < end) {
      if (now >= nextAt) {
        nextAt = Double.MAX_VALUE;
        next.run();
      }
      double heading = place.heading() + motion.turn() * STEP_SECONDS;
      place =
          new Stance(
              new Point2(
                  place.point().x() + motion.forward() * Math.cos(heading) * STEP_SECONDS,
                  place.point().y() + motion.forward() * Math.sin(heading) * STEP_SECONDS),
              heading);
      seen.addLast(place);
      while (seen.size() > delaySeconds / STEP_SECONDS + 1) {
        seen.removeFirst();
      }
      now += STEP_SECONDS;
    }
  }

  private WheeledBase base(double metresPerSecond, double radiansPerSecond) {
    return new WheeledBase(
        WHEELS,
        new WheelMotors() {
          @Override
          public void spin(List<Double> wheels) {
            motion = WHEELS.motion(wheels);
          }

          @Override
          public Optional<String> fault() {
            return Optional.empty();
          }
        },
        new Localization() {
          @Override
          public Point2 position() {
            return seen.getFirst().point();
          }

          @Override
          public double heading() {
            return seen.getFirst().heading();
          }

          @Override
          public boolean isFree(Segment ahead) {
            return true;
          }
        },
        (seconds, then) -> {
          next = then;
          nextAt = now + seconds;
        },
        new WheeledBase.Limits(metresPerSecond, radiansPerSecond, 0.25, 50, 0.1, 0.1, 0.05, 0.1));
  }

  private Completion completion() {
    return new Completion() {
      @Override
      public void done() {
        done = true;
      }

      @Override
      public void failed(String reason) {
        throw new AssertionError(reason);
      }
    };
  }
}
