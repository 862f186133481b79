package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;

/**
 * Each script of the page, begun by the command that stands there, does in the simulated world what
 * stands there. What an appliance, a lock or a valve is at, its own simulation says alone.
 */
@MaestroTest(home = "household", scene = "household-night", patience = 3600)
class ScriptsPeopleWantTest {

  private static Pursuit begin(Stage stage, String script) {
    Pursuit begun = stage.begin(WantedScript.named(script).goal());
    run(stage, 5);
    return begun;
  }

  private static void run(Stage stage, int seconds) {
    stage.run(Duration.ofSeconds(seconds));
  }

  @Test
  void goodNight(Stage stage) {
    assertThat(
            stage.goal(
                "(and (= (level living-lamp) 1) (= (level porch-lamp) 1) (switchedOn television))"))
        .isReached();

    assertThat(begin(stage, "goodNight").await()).isReached();

    assertThat(stage.world()).hasLampAt("living-lamp", 0).hasLampAt("porch-lamp", 0);
    assertThat(stage.world().opening("living-blind")).isZero();
    assertThat(stage.knowledge()).knows("(locked front-door)").excludes("(switchedOn television)");
  }

  @Test
  void leave(Stage stage) {
    stage.world().hide("Ada", false);
    stage.world().setDoor("front-door", true);
    run(stage, 5);
    assertThat(stage.goal("(and (= (level living-lamp) 1) (switchedOn washer))")).isReached();

    Pursuit leaving = begin(stage, "leave");
    run(stage, 60);
    assertThat(stage.world()).hasLampAt("living-lamp", 1);
    stage.world().moveByHand("Ada", new Position(1, 1.5, 0));

    assertThat(leaving.await()).isReached();
    assertThat(stage.world()).hasLampAt("living-lamp", 0);
    assertThat(stage.world().isOpen("front-door")).isFalse();
    assertThat(stage.knowledge()).knows("(locked front-door)").excludes("(switchedOn washer)");
  }

  @Test
  void comeHome(Stage stage) {
    begin(stage, "comeHome");
    stage.world().setDoor("front-door", true);
    run(stage, 30);

    assertThat(stage.world()).hasLuxAtLeast("living", 150);
    assertThat(stage.knowledge()).knows("(showing television News)");
  }

  @Test
  void whoGoesOutDoesNotComeHome(Stage stage) {
    stage.world().hide("Ada", false);
    begin(stage, "comeHome");
    stage.world().setDoor("front-door", true);
    run(stage, 30);

    assertThat(stage.world()).hasLampAt("living-lamp", 0);
  }

  /** The clock begins on a Thursday, at one o'clock. */
  @Test
  void wakeUp(Stage stage) {
    begin(stage, "wakeUp");
    stage.run(Duration.ofMinutes(5 * 60 + 29));
    assertThat(stage.world()).hasLampAt("bed-lamp", 0);
    stage.run(Duration.ofMinutes(3));
    assertThat(stage.world()).hasLampAt("bed-lamp", 0.25);
    stage.run(Duration.ofMinutes(5));
    assertThat(stage.world()).hasLampAt("bed-lamp", 0.5);
    assertThat(stage.world().opening("bed-blind")).isZero();
    stage.run(Duration.ofMinutes(5));
    assertThat(stage.world()).hasLampAt("bed-lamp", 1);
    assertThat(stage.world().opening("bed-blind")).isEqualTo(1);
  }

  @Test
  void answerDoor(Stage stage) {
    begin(stage, "answerDoor");
    assertThat(stage.goal("(switchedOn television)")).isReached();
    stage.world().hide("Guest", false);
    run(stage, 10);
    assertThat(stage.world()).hasLampAt("porch-lamp", 1);
    assertThat(stage.knowledge()).excludes("(switchedOn television)");

    run(stage, 300);
    stage.world().hide("Guest", true);
    run(stage, 50);
    assertThat(stage.world()).hasLampAt("porch-lamp", 1);
    stage.world().hide("Guest", false);
    run(stage, 100);
    assertThat(stage.world()).as("the next guest has come").hasLampAt("porch-lamp", 1);
    stage.world().hide("Guest", true);
    run(stage, 70);
    assertThat(stage.world()).hasLampAt("porch-lamp", 0);
  }

  @Test
  void saveLight(Stage stage) {
    begin(stage, "saveLight");
    stage.world().hide("Ada", false);
    assertThat(stage.goal("(= (level living-lamp) 1)")).isReached();
    run(stage, 600);
    assertThat(stage.world()).hasLampAt("living-lamp", 1);
    stage.world().hide("Ada", true);
    run(stage, 290);
    assertThat(stage.world()).hasLampAt("living-lamp", 1);
    run(stage, 15);
    assertThat(stage.world()).hasLampAt("living-lamp", 0);

    assertThat(stage.goal("(= (level bed-lamp) 1)")).isReached();
    run(stage, 310);
    assertThat(stage.world()).as("another room").hasLampAt("bed-lamp", 0);
  }

  @Test
  void stopWater(Stage stage) {
    begin(stage, "stopWater");
    assertThat(stage.goal("(switchedOn washer)")).isReached();
    stage.world().hide("puddle", false);
    run(stage, 10);

    assertThat(stage.knowledge()).knows("(shut main-valve)").excludes("(switchedOn washer)");
    assertThat(stage.world()).hasLuxAtLeast("kitchen", 150);
  }

  @Test
  void aLeakGoesBeforeWhatIsKeptOtherwise(Stage stage) {
    begin(stage, "stopWater");
    Pursuit dark = stage.begin("(keep (= (level kitchen-lamp) 0))");
    run(stage, 60);
    stage.world().hide("puddle", false);

    dark.awaitTelling("goes first");
    stage.await("it is light", () -> stage.world().lampLevel("kitchen-lamp") == 1);
  }

  @Test
  void restock(Stage stage) {
    begin(stage, "restock");
    stage.world().moveByHand("Ada", new Position(6.6, 2.8, 0));
    stage.world().hide("Ada", false);
    run(stage, 60);
    stage.world().hide("Tea", true);
    run(stage, 60);
    assertThat(stage.world()).hasInZone("Oats", "store").hasInZone("tim", "living");
    stage.world().hide("Ada", true);
    run(stage, 120);

    assertThat(stage.world())
        .hasInZone("Oats", "shelf")
        .hasPutDown("Oats")
        .hasInZone("tim", "living");
  }

  @Test
  void whoFindsNothingToFetchComesBackAllTheSame(Stage stage) {
    stage.world().hide("Tea", true);
    Pursuit restocking = stage.begin("(restock)").awaitTelling("tim reports: tim is in store");
    stage.world().hide("Oats", true);

    assertThat(restocking.await()).isNotReached();
    assertThat(stage.world()).hasInZone("tim", "living");
  }

  @Test
  void morningRound(Stage stage) {
    begin(stage, "morningRound").awaitTelling("desk asks for");
    stage.world().hide("Rice", true);
    stage.world().charge("tim", 0.3);
    run(stage, 10);
    Pursuit today = stage.begin("(morningRound)");
    stage.run(Duration.ofMinutes(15));
    assertThat(stage.world()).hasInZone("Oats", "store");
    assertThat(stage.world().isAtStation("tim")).isTrue();

    assertThat(today.await()).isReached();
    assertThat(stage.world()).hasInZone("Oats", "shelf").hasInZone("tim", "living");
    assertThat(stage.world().charge("tim")).isGreaterThan(0.9);
  }

  @Test
  void readingLight(Stage stage) {
    begin(stage, "readingLight");
    assertThat(stage.world().lux("living")).isLessThan(10);
    stage.world().hide("Ada", false);
    run(stage, 10);
    assertThat(stage.world()).hasLuxAtLeast("living", 200);
  }

  @Nested
  @MaestroTest(home = "household", scene = "household-noon")
  class AtNoon {
    private static final Pattern KEPT =
        Pattern.compile("^\\./maestro goal '(.*\\(keep .*)'$", Pattern.MULTILINE);

    @Test
    void readingLightIsThatOfTheDayUntilItIsTooLittle(Stage stage) {
      begin(stage, "readingLight");
      assertThatItIsNeitherDarkNorGlaring(stage);
    }

    @Test
    void soIsWhatIsKeptWithoutAScript(Stage stage) {
      Matcher kept = KEPT.matcher(WantedScript.page());
      assertThat(kept.find()).isTrue();
      stage.begin(kept.group(1));
      run(stage, 5);
      assertThatItIsNeitherDarkNorGlaring(stage);
    }

    private static void assertThatItIsNeitherDarkNorGlaring(Stage stage) {
      assertThat(stage.world().lux("living")).isGreaterThan(1200);
      stage.world().hide("Ada", false);
      run(stage, 30);
      assertThat(stage.world().lux("living")).isBetween(200.0, 1200.0);
      assertThat(stage.world().opening("living-blind")).isEqualTo(0.5);
      assertThat(stage.world()).hasLampAt("living-lamp", 0);
      stage.world().setClouds(1);
      run(stage, 150);
      assertThat(stage.world().lux("living")).isBetween(200.0, 1200.0);
    }
  }
}
