package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** The example of ADE, 4.2, in a kitchen with a glass on the table and one on the floor (A62). */
@MaestroTest(home = "evening", scene = "glasses")
class GlassOnTheFloorTest {
  /** What a camera has seen of a thing's place counts for ten minutes. */
  private static final Duration LONGER_THAN_KNOWN = Duration.ofMinutes(11);

  /** What the kitchen's camera has seen tells which glass is meant (A59). */
  @Test
  void theOneOnTheFloorIsLookedAtAndPutIntoTheRefrigerator(Stage stage) {
    assertThat(stage.goal("(canSee cam-kitchen glass-1)")).isReached();
    assertThat(stage.goal("(canSee cam-kitchen glass-2)")).isReached();

    stage
        .speaker("Dave")
        .in("kitchen")
        .begins("put the glass")
        .looksAt()
        .then("on the")
        .looksAt()
        .then("floor")
        .looksAt("glass-2", "floor-k")
        .doesNotNod()
        .hasBegun(0)
        .then("in the refrigerator")
        .looksAt("glass-2", "refrigerator")
        .nods()
        .hasBegun(1)
        .ends()
        .means("(initCNP (:goal (in glass-2 refrigerator)))")
        .isReached();
    assertThat(stage.world())
        .hasPutDown("glass-2")
        .hasPutAway("glass-2")
        .hasInZone("glass-2", "kitchen");
    assertThat(stage.knowledge()).knows("(in glass-2 refrigerator)");
    assertThat(stage.world()).hasInSight("glass-1");

    stage
        .speaker("Dave")
        .says("no, just dump it in the sink")
        .means("(initCNP (:goal (in glass-2 sink)))")
        .isReached();
    assertThat(stage.world()).hasPutAway("glass-2");
    assertThat(stage.knowledge()).knows("(in glass-2 sink)");
  }

  /** Things come into what words can mean when they are seen, and go when that is too old (A59). */
  @Test
  void whatWasSeenTooLongAgoIsNotMeantUntilItIsSeenAgain(Stage stage) {
    seeBothGlasses(stage);
    theOneOnTheFloorIsMeant(stage);

    stage.run(LONGER_THAN_KNOWN);
    stage
        .speaker("Dave")
        .in("kitchen")
        .begins("put the glass on the floor in the refrigerator")
        .looksAt("refrigerator")
        .doesNotNod()
        .hasBegun(0)
        .ends()
        .asks("Which glass do you mean?");

    seeBothGlasses(stage);
    theOneOnTheFloorIsMeant(stage);
  }

  private static void seeBothGlasses(Stage stage) {
    assertThat(stage.goal("(canSee cam-kitchen glass-1)")).isReached();
    assertThat(stage.goal("(canSee cam-kitchen glass-2)")).isReached();
  }

  private static void theOneOnTheFloorIsMeant(Stage stage) {
    stage
        .speaker("Dave")
        .in("kitchen")
        .begins("put the glass on the floor")
        .looksAt("glass-2", "floor-k")
        .hasBegun(0);
  }

  @Test
  void beforeAnybodyHasSeenThemNoneIsLookedAt(Stage stage) {
    stage
        .speaker("Dave")
        .in("kitchen")
        .begins("put the glass on the floor in the refrigerator")
        .looksAt("refrigerator")
        .doesNotNod()
        .hasBegun(0)
        .ends()
        .asks("Which glass do you mean?");
  }
}
