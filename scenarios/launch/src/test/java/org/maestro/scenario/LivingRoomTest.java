package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/**
 * The action script of ADE's section 5, as it is printed there, prepares a living room: its calls
 * go to whoever can do them there, in its order (ADE, 5; A75, A76), by what is known of persons
 * (ADE, 4.1; A57).
 */
class LivingRoomTest {

  /** What the script runs, what it is given, and what devices do for it, without the places. */
  private static List<String> deeds(GoalOutcome outcome) {
    return outcome.story().stream()
        .filter(
            entry ->
                entry.kind() == StoryEntry.Kind.STEP
                    || entry.kind() == StoryEntry.Kind.KNOWN && entry.text().startsWith("["))
        .map(entry -> entry.text().replaceFirst("^\\[[0-9.]+] ", ""))
        .filter(text -> !text.startsWith("Achieve"))
        .map(text -> text.replaceFirst("^Step \\d of \\d: ", ""))
        .toList();
  }

  private static List<String> expected(String person, String minute, String show) {
    return List.of(
        "Run (activateLights livingroom).",
        "lux measures the light in livingroom.",
        "lamp-1 is set to 1.",
        "lamp-2 is set to 0.5.",
        "lux measures the light in livingroom.",
        "Run (currenttime).",
        "?minute is " + minute + ".",
        "?currenttime is " + minute + ".",
        "Run (queryPrefs livingroom %s \"TV show\" %s).".formatted(person, minute),
        "?choice is " + show + ".",
        "?show is " + show + ".",
        "Run (activateTV livingroom).",
        "television is switched on.",
        "Run (selectTVshow livingroom %s).".formatted(show),
        "television is tuned to %s.".formatted(show));
  }

  @Nested
  @MaestroTest(home = "livingroom", scene = "livingroom-evening")
  class InTheEvening {

    @Test
    void daveFindsTheOperaInALitRoom(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Dave)");

      assertThat(outcome).isReached();
      assertThat(deeds(outcome)).isEqualTo(expected("Dave", "1215", "Opera"));
      assertThat(stage.world().lux("livingroom")).isGreaterThan(150);
      assertThat(stage.knowledge()).knows("(showing television Opera)");
    }

    @Test
    void eveFindsWhatSheLikes(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Eve)");

      assertThat(outcome).isReached();
      assertThat(deeds(outcome)).isEqualTo(expected("Eve", "1215", "Cartoons"));
    }
  }

  @Nested
  @MaestroTest(home = "livingroom", scene = "livingroom-morning")
  class InTheMorning {

    @Test
    void daveFindsTheNews(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Dave)");

      assertThat(outcome).isReached();
      assertThat(deeds(outcome)).isEqualTo(expected("Dave", "450", "News"));
      assertThat(stage.knowledge()).knows("(showing television News)");
    }

    @Test
    void whoLikesNothingNowHasNoShowChosen(Stage stage) {
      GoalOutcome outcome = stage.goal("(prepareRoom livingroom Eve)");

      assertThat(outcome)
          .isNotReached()
          .isExplainedBy("There is no ?s - Show of which it is known");
      assertThat(stage.knowledge()).excludes("(switchedOn television)");
    }
  }
}
