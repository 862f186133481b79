package org.maestro.junit;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.scene.WorldEvent;

/**
 * A robot on another planet is told by words where to go, until it is at a place from which it can
 * transmit (ADE, 4; A46 to A49).
 */
@MaestroTest(home = "exploration", scene = "exploration")
class ExplorationByWordsTest {
  private static final Duration SECOND = Duration.ofSeconds(1);

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "turn right | (perform (:script turnRight) (:degrees 90))",
        "Could you turn to the left, please? | (perform (:script turnLeft) (:degrees 90))",
        "turn right by 30 degrees | (perform (:script turnRight) (:degrees 30))",
        "turn around | (perform (:script turnLeft) (:degrees 180))",
        "go straight | (perform (:script goStraight) (:who explorer))",
        "drive straight ahead | (perform (:script goStraight) (:who explorer))",
        "go forward two metres | (perform (:script goForward) (:metres 2) (:who explorer))",
        "go two and a half metres forward | (perform (:script goForward) (:metres 2.5) (:who explorer))",
        "stop | (perform (:script standStill))",
        "take a reading | (perform (:script takeReading) (:who explorer))",
        "what is the signal? | (perform (:script takeReading) (:who explorer))",
        "how strong is the signal? | (perform (:script takeReading) (:who explorer))",
      })
  void whatIsSaidIsUnderstood(String words, String meaning, Stage stage) {
    stage.speaker("explorer").says(words).means(meaning);
  }

  @Test
  void aScriptedSubjectFindsThePlaceAndTransmits(Stage stage) {
    List<Duration> sent = new CopyOnWriteArrayList<>();
    stage
        .world()
        .listen(
            event -> {
              if (event.kind() == WorldEvent.Kind.TRANSMITTED) {
                sent.add(event.at());
              }
            });
    Speaker subject = stage.speaker("explorer");
    Point2 peak = stage.world().signal().peak();
    Duration begun = stage.clock().now();

    subject.says("go straight");
    stage.await("the robot is below the peak", () -> place(stage).x() >= peak.x());
    subject.says("stop").isReached();
    subject.says("turn left").isReached();
    subject.says("go straight");
    stage.await("the robot is near the peak", () -> place(stage).distance(peak) < 1.5);
    subject.says("stop").isReached();
    subject.says("transmit").isReached();

    subject.awaits("The data is sent.");
    assertThat(sent).hasSize(1);
    assertThat(sent.get(0).minus(begun)).isBetween(Duration.ofSeconds(5), Duration.ofMinutes(2));
  }

  @Test
  void readingsGrowTowardsThePlace(Stage stage) {
    Speaker subject = stage.speaker("explorer");
    Point2 peak = stage.world().signal().peak();
    List<Double> readings = new ArrayList<>();
    readings.add(reading(stage, subject));
    while (peak.x() - place(stage).x() > 1) {
      subject.says("go forward two metres").isReached();
      readings.add(reading(stage, subject));
    }
    subject.says("turn left").isReached();
    while (peak.y() - place(stage).y() > 1) {
      subject.says("go forward two metres").isReached();
      readings.add(reading(stage, subject));
    }

    assertThat(readings).isSorted();
    assertThat(readings.get(0)).isLessThan(40);
    assertThat(readings.get(readings.size() - 1)).isGreaterThan(80);
  }

  /** That which it is told, which is what the field has where the robot truly is. */
  private static double reading(Stage stage, Speaker subject) {
    subject.says("take a reading").isReached();
    double strength = Math.floor(stage.world().signal().strength(place(stage)));
    subject.awaits("The signal is %.0f.".formatted(strength));
    return strength;
  }

  @Test
  void whereTheSignalIsTooWeakNothingIsSentAndItIsSaidWhy(Stage stage) {
    stage
        .speaker("explorer")
        .says("transmit")
        .means("(perform (:script sendData) (:who explorer))")
        .isNotReached("and has to be 80 at least");

    MaestroAssertions.assertThat(stage.knowledge()).excludes("(transmitted rover)");
  }

  @Test
  void reportsComeAtFixedTimesAndOnlyTheScriptKnowsThem(Stage stage) {
    Speaker subject = stage.speaker("explorer");
    List<String> moods = new CopyOnWriteArrayList<>();
    stage.platform().desk().whenShown((agent, mood) -> moods.add(mood.word()));
    subject.says("take a reading").isReached();
    Duration before = stage.clock().now();
    stage.begin("(mission explorer \"stressed\" 0.8)");

    stage.run(Duration.ofSeconds(119));
    assertThat(moods).isEmpty();
    for (int left = 180; left > 0; left -= 30) {
      subject.awaits("My battery is low. I have %d seconds left.".formatted(left));
      assertThat(stage.clock().now().minus(before))
          .isBetween(Duration.ofSeconds(300 - left), Duration.ofSeconds(300 - left).plus(SECOND));
    }
    assertThat(moods).containsExactly("stressed");
    subject.awaits("My battery is empty.");
    assertThat(stage.clock().now().minus(before))
        .isBetween(Duration.ofSeconds(300), Duration.ofSeconds(301));
    subject.says("transmit").isNotReached("exhausted");
  }

  @Test
  void whoIsToldToStopStopsWhoeverHadItGo(Stage stage) {
    Pursuit drive = stage.begin("(goStraight explorer)");
    stage.run(Duration.ofSeconds(4));
    stage.speaker("explorer").says("stop").isReached();
    Point2 there = place(stage);
    stage.run(Duration.ofSeconds(4));

    assertThat(place(stage)).isEqualTo(there);
    MaestroAssertions.assertThat(drive.await()).isReached();
  }

  @Test
  void whereARockIsInItsWayItSaysSo(Stage stage) {
    Speaker subject = stage.speaker("explorer");
    subject.says("turn left 45 degrees").isReached();
    subject.says("go straight").isReached();
    subject.awaits("Something is in my way.");
    subject.says("go forward one metre").isNotReached("something is in the way");
  }

  private static Point2 place(Stage stage) {
    return stage.world().position("rover").orElseThrow().floor();
  }
}
