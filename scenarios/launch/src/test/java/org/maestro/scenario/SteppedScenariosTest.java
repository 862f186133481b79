package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Saying;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;

/** Bob's cup under all the circumstances that the platform has to cope with. */
class SteppedScenariosTest {

  private static final String WISH = "(nextTo Cup Bob)";

  @Nested
  @MaestroTest(home = "bob", scene = "bob-lit")
  class InTheLight {

    @Test
    void noLampIsTouched(Stage stage) {
      GoalOutcome outcome = stage.goal(WISH);

      assertThat(outcome).isReached().neverTells("is set to");
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }

    @Test
    void anAgentThatCanSeeTheCupIsBound(Stage stage) {
      GoalOutcome outcome = stage.goal("(canSee ?agent Cup)");

      assertThat(outcome).isReached().hasBinding("agent", "cam-b").hasCallsAtMost(6);
    }

    @Test
    void aGoalThatHoldsNeedsNoMoreCalls(Stage stage) {
      assertThat(stage.goal(WISH)).isReached();

      assertThat(stage.goal(WISH)).isReached().hasCalls(0);
    }

    @Test
    void aLostRobotWhoseCupFellIsExplained(Stage stage) {
      Pursuit pursuit = stage.begin(WISH);
      stage.await("rose holds the cup", () -> stage.world().holder("Cup").isPresent());
      stage.kill("rose");

      assertThat(pursuit.await()).isNotReached();
      assertThat(stage.world()).hasPutDown("Cup");
    }
  }

  @Nested
  @MaestroTest(home = "bob-two-robots", scene = "bob-two-robots")
  class WithASecondRobot {

    /** Who talks with the home meanwhile notices nothing of it (ADE, 5; A92). */
    @Test
    void itTakesOverDuringADialogueAndNobodyIsToldOfAnError(Stage stage) {
      Speaker bob = stage.speaker("Bob").in("room-a");
      Saying asked = bob.says("bring me the cup").means("(initCNP (:goal (nextTo Cup Bob)))");
      stage.await("somebody holds the cup", () -> stage.world().holder("Cup").isPresent());
      String first = stage.world().holder("Cup").orElseThrow();
      stage.kill(first);

      bob.says("where is Bob?").means("(query-ref (in Bob ?where))");
      asked.isReached();
      bob.hasHeardNothing();
      bob.says("where is Bob?").means("(query-ref (in Bob ?where))");

      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }

    @Test
    void itTakesOverWhenTheFirstDiesCarrying(Stage stage) {
      Pursuit pursuit = stage.begin(WISH);
      stage.await("somebody holds the cup", () -> stage.world().holder("Cup").isPresent());
      String first = stage.world().holder("Cup").orElseThrow();
      stage.kill(first);

      GoalOutcome outcome = pursuit.await();

      String second = first.equals("rose") ? "tim" : "rose";
      assertThat(outcome).isReached().tells(second + " places Cup at Bob");
      assertThat(stage.world()).hasNextTo("Cup", "Bob").hasPutDown("Cup");
    }
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-cup-in-a")
  class WithTheCupInTheOtherRoom {

    @Test
    void roseGoesThere(Stage stage) {
      assertThat(stage.goal(WISH)).isReached();
      assertThat(stage.world()).hasNextTo("Cup", "Bob").hasLampAt("lamp-b1", 0);
    }
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-weak-lamps")
  class WithWeakLamps {

    @Test
    void anotherLampIsAdded(Stage stage) {
      assertThat(stage.goal(WISH)).isReached();
      assertThat(stage.world()).hasNextTo("Cup", "Bob").hasLuxAtLeast("zone-b", 72);
    }
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-hidden")
  class WithAHiddenCup {

    @Test
    void theSearchEndsWithAnExplanation(Stage stage) {
      assertThat(stage.goal(WISH)).isNotReached().isExplainedBy("Cup");
      assertThat(stage.knowledge()).excludes("(or (in Cup zone-a) (in Cup zone-b))");
    }
  }

  @Nested
  @MaestroTest(home = "bob", scene = "bob-dark")
  class InTheDark {

    @Test
    void withoutLampsTheLightNeededAndPossibleIsTold(Stage stage) {
      stage.kill("lamp-b1");
      stage.kill("lamp-b2");

      // Lamp B3 is left: it adds 28 lux to the 17 that are there.
      assertThat(stage.goal(WISH))
          .isNotReached()
          .isExplainedBy("illuminance")
          .isExplainedBy("zone-b")
          .isExplainedBy("72")
          .isExplainedBy("45.");
    }

    @Test
    void aLampThatDiesAfterBeingChosenIsReplaced(Stage stage) {
      Pursuit pursuit = stage.begin(WISH).awaitTelling("lamp-b2 is set to 1");
      stage.kill("lamp-b2");

      assertThat(pursuit.await()).isReached().tells("lamp-b3 is set to 1");
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }

    @Test
    void aRobotThatIsRevivedJoinsAnew(Stage stage) {
      stage.kill("rose");
      stage.await("rose is gone", () -> !stage.platform().presentMembers().contains("rose"));
      assertThat(stage.goal(WISH)).isNotReached();

      stage.revive("rose");
      stage.await("rose is back", () -> stage.platform().presentMembers().contains("rose"));
      assertThat(stage.goal(WISH)).isReached();
    }

    @Test
    void aCupThatIsMovedWhileSoughtIsFound(Stage stage) {
      Pursuit pursuit = stage.begin(WISH).awaitTelling("Plan 1");
      stage.world().moveByHand("Cup", new Position(2.2, 1.0, 0));

      assertThat(pursuit.await()).isReached();
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }

    @Test
    void anUnknownThingIsRefused(Stage stage) {
      assertThat(stage.goal("(nextTo Mug Bob)")).isNotReached().isRefused().isExplainedBy("Mug");
    }

    @Test
    void aMalformedGoalIsRefusedWithItsColumn(Stage stage) {
      assertThat(stage.goal("(nextTo Cup")).isNotReached().isRefused().isExplainedBy("column");
    }
  }
}
