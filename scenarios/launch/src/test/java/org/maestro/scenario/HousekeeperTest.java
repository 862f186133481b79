package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.ontology.floor.Point2;

/** A robot is to clean, and not to disturb: what it is worth decides (ADE, 4.1; A56). */
@MaestroTest(home = "housekeeper", scene = "housekeeper")
class HousekeeperTest {
  @Test
  void itStandsStillForAPersonAndCleansForASpillAllTheSame(Stage stage) {
    stage.begin("(keepStill)");
    stage.begin("(clean kitchen)");
    assertThat(metres(stage, 60)).as("alone").isGreaterThan(3);
    stage.world().hide("Dave", false);
    stage.run(Duration.ofSeconds(25));
    assertThat(metres(stage, 60)).as("somebody is there").isZero();
    stage.goal("(spilled kitchen)");
    assertThat(metres(stage, 25)).as("something was spilled").isGreaterThan(3);
    assertThat(metres(stage, 60)).as("it is clean").isZero();
    stage.world().hide("Dave", true);
    assertThat(metres(stage, 60)).as("alone again").isGreaterThan(3);
  }

  /** How far it has driven in so many seconds. */
  private static double metres(Stage stage, int seconds) {
    double metres = 0;
    for (int second = 0; second < seconds; second++) {
      Point2 before = place(stage);
      stage.run(Duration.ofSeconds(1));
      metres += before.distance(place(stage));
    }
    return metres;
  }

  private static Point2 place(Stage stage) {
    return stage.world().position("rosie").orElseThrow().floor();
  }
}
