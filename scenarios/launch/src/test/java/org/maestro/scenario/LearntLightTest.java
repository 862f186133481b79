package org.maestro.scenario;

import static org.assertj.core.api.Assertions.within;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.util.List;
import java.util.OptionalDouble;
import org.assertj.core.api.Assertions;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.world.LampLight;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;

/**
 * What lamps really give is learnt from what is measured after they were set, so that it is planned
 * right the next time.
 */
class LearntLightTest {
  private static final String BRIGHT = "(>= (illuminance zone-b) 72)";
  private static final String OFF =
      "(and (= (level lamp-b1) 0) (= (level lamp-b2) 0) (= (level lamp-b3) 0))";

  private static OptionalDouble gain(Stage stage, String lamp, String place) {
    return stage
        .knowledge()
        .snapshot()
        .number((Expression.Fluent) SlParser.expression("(gain %s %s)".formatted(lamp, place)));
  }

  private static List<String> causes(GoalOutcome outcome) {
    return outcome.story().stream()
        .filter(entry -> entry.kind() == StoryEntry.Kind.REPLAN)
        .map(StoryEntry::text)
        .toList();
  }

  private static void dark(Stage stage) {
    assertThat(stage.goal(OFF)).isReached();
    assertThat(stage.goal("(<= (illuminance zone-b) 20)")).isReached().isConfirmed();
  }

  private static void brightThenDark(Stage stage) {
    assertThat(stage.goal(BRIGHT)).isReached();
    dark(stage);
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-weak-lamps")
  class WithWeakLamps {

    @Test
    void theSecondTimeItIsPlannedRight(Stage stage) {
      GoalOutcome first = stage.goal(BRIGHT);
      assertThat(first).isReached();
      Assertions.assertThat(causes(first))
          .anyMatch(cause -> cause.contains("illuminance of zone-b is 49"));
      dark(stage);

      GoalOutcome second = stage.goal(BRIGHT);

      assertThat(second)
          .isReached()
          .isConfirmed()
          .tells("Learnt from measurements before:")
          .tells("the gain of lamp-b1, zone-b is");
      Assertions.assertThat(causes(second)).isEmpty();
      Assertions.assertThat(gain(stage, "lamp-b1", "zone-b").orElseThrow())
          .isCloseTo(16, within(2.0));
      Assertions.assertThat(gain(stage, "lamp-b3", "zone-b").orElseThrow())
          .isCloseTo(28, within(1.0));
    }

    @Test
    void whereNothingIsMeasuredALampIsAsWeak(Stage stage) {
      stage.begin("(keep (>= (illuminance (at 4.1 1.5 0.8)) 1))");
      stage.await("a point", () -> gain(stage, "lamp-b1", "at_4.1_1.5_0.8").orElse(0) > 0);
      double stated = gain(stage, "lamp-b1", "at_4.1_1.5_0.8").orElseThrow();

      brightThenDark(stage);

      Assertions.assertThat(gain(stage, "lamp-b1", "at_4.1_1.5_0.8").orElseThrow() / stated)
          .isCloseTo(0.5, within(0.07));
    }

    @Test
    void aLampThatWasCleanedIsAsStatedAgain(Stage stage) {
      brightThenDark(stage);
      stage.world().weaken("lamp-b1", 1);
      stage.world().weaken("lamp-b2", 1);

      brightThenDark(stage);
      brightThenDark(stage);

      GoalOutcome then = stage.goal(BRIGHT);
      assertThat(then).isReached();
      Assertions.assertThat(causes(then)).isEmpty();
      assertThat(stage.world()).hasLampAt("lamp-b3", 0);
    }
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark")
  class WithALampThatWasMoved {

    @Test
    void theSecondTimeItIsPlannedRight(Stage stage) {
      Pose farther = Pose.parse("5.9 2.9 2.8");
      stage.world().lighting().put("lamp-b2", new LampLight(farther, 443.5, 100, 1, 0));
      GoalOutcome first = stage.goal(BRIGHT);
      assertThat(first).isReached();
      Assertions.assertThat(causes(first)).hasSizeGreaterThan(1);
      dark(stage);

      GoalOutcome second = stage.goal(BRIGHT);

      assertThat(second).isReached().tells("the gain of lamp-b2, zone-b is");
      Assertions.assertThat(causes(second)).isEmpty();
    }
  }
}
