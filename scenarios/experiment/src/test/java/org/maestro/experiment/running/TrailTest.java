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
}
