package org.maestro.experiment.running;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.world.PathPoint;

class TrailTest {

  @Test
  void standsDrivesEvenlyAndStands() {
    Trail trail =
        Trail.sampled(
            List.of(
                new PathPoint(Duration.ofSeconds(2), new Point2(0, 0)),
                new PathPoint(Duration.ofSeconds(4), new Point2(2, 0))),
            new Point2(0, 0),
            Duration.ofSeconds(1),
            Duration.ofSeconds(6),
            Duration.ofSeconds(1));

    assertThat(trail.places()).extracting(Point2::x).containsExactly(0.0, 0.0, 1.0, 2.0, 2.0, 2.0);
    assertThat(trail.length()).isEqualTo(2);
  }

  @Test
  void straysWhereTheOtherWasNowhereNear() {
    Trail straight = along(new Point2(0, 0), new Point2(1, 0), new Point2(2, 0), new Point2(3, 0));
    Trail astray = along(new Point2(0, 0), new Point2(1, 0), new Point2(1, 1), new Point2(1, 2));

    assertThat(astray.strayFrom(straight, 0.5, 1)).isEqualTo(2);
    assertThat(astray.strayFrom(straight, 1, 1)).isEqualTo(1);
    assertThat(straight.strayFrom(straight, 0.5, 1)).isZero();
  }

  private static Trail along(Point2... places) {
    return new Trail(Duration.ofSeconds(1), List.of(places));
  }
}
