package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.Question;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/** What is done before somebody has said all (ADE, 2 and 4.2; A12, A60, A63). */
@MaestroTest(home = "evening", scene = "evening")
class ActingWhileListeningTest {

  private static void await(Stage stage, String formula) {
    stage.await(
        formula,
        () ->
            new Question(stage.knowledge().snapshot())
                    .queryIf(
                        SlParser.formula(formula, stage.knowledge().home().vocabulary()::isFluent))
                == Truth.TRUE);
  }

  @Test
  void theBlindsAreDownBeforePlease(Stage stage) {
    Unfinished words =
        stage
            .speaker("Dave")
            .in("livingroom")
            .begins("could you lower")
            .doesNotNod()
            .hasBegun(0)
            .then("the blinds,")
            .looksAt("blinds-living")
            .nods()
            .hasBegun(1);
    await(stage, "(= (opening blinds-living) 0)");

    words.then("please").hasBegun(1).ends().isReached();
  }

  @Test
  void whatIsTakenBackIsUndone(Stage stage) {
    Unfinished words =
        stage
            .speaker("Dave")
            .in("livingroom")
            .begins("turn on the kitchen light")
            .looksAt("kitchen-lamp")
            .nods()
            .hasBegun(1);
    await(stage, "(= (level kitchen-lamp) 1)");

    words
        .then("no I mean")
        .undoes(1)
        .hasBegun(0)
        .then("the bedroom light")
        .hasBegun(1)
        .ends()
        .means("(initCNP (:goal (= (level bed-lamp) 1)))")
        .isReached();
    await(stage, "(= (level kitchen-lamp) 0)");
    assertThat(stage.knowledge()).knows("(= (level bed-lamp) 1)");
  }

  /** What is wanted in the end is not undone with what was begun on the way to it. */
  @Test
  void whatIsSaidMoreCloselyStaysSo(Stage stage) {
    Unfinished words =
        stage.speaker("Dave").in("kitchen").begins("turn on the kitchen light").hasBegun(1);
    await(stage, "(= (level kitchen-lamp) 1)");

    words
        .instead("turn the kitchen light to thirty percent")
        .undoes(1)
        .ends()
        .means("(initCNP (:goal (= (level kitchen-lamp) 0.3)))")
        .isReached();
    stage.run(Duration.ofSeconds(30));
    assertThat(stage.knowledge()).knows("(= (level kitchen-lamp) 0.3)");
  }

  @Test
  void whatTheRecogniserHearsOtherwiseIsUndone(Stage stage) {
    Unfinished words =
        stage.speaker("Dave").in("kitchen").begins("turn on the stove light").hasBegun(0);

    words.instead("turn off the kitchen light").hasBegun(1).instead("turn of").undoes(1);
  }

  @Test
  void whoBreaksOffGetsNothingDone(Stage stage) {
    stage.speaker("Dave").in("livingroom").begins("turn on the kitchen light").hasBegun(1);
    await(stage, "(= (level kitchen-lamp) 1)");
    await(stage, "(= (level kitchen-lamp) 0)");
  }

  @Test
  void whatIsALongerWishInTheEndIsDoneAsAWhole(Stage stage) {
    stage
        .speaker("Dave")
        .in("livingroom")
        .begins("turn on the kitchen light")
        .hasBegun(1)
        .then("and the bedroom light")
        .hasBegun(2)
        .ends()
        .means("(initCNP (:goal (and (= (level kitchen-lamp) 1) (= (level bed-lamp) 1))))")
        .isReached();
    assertThat(stage.knowledge()).knows("(= (level kitchen-lamp) 1)");
  }

  @Test
  void whatHasATimeIsNotLeftDone(Stage stage) {
    Unfinished words =
        stage.speaker("Dave").in("livingroom").begins("turn on the kitchen light").hasBegun(1);
    await(stage, "(= (level kitchen-lamp) 1)");

    words
        .then("in ten minutes")
        .undoes(1)
        .hasBegun(0)
        .ends()
        .means("(after 600 (initCNP (:goal (= (level kitchen-lamp) 1))))");
    await(stage, "(= (level kitchen-lamp) 0)");
  }

  /** Heat, locks and all of a house are asked about first; children get no more than they may. */
  @Test
  void whatIsAskedAboutOrForbiddenIsNotBegun(Stage stage) {
    stage.speaker("Dave").in("kitchen").begins("unlock the front door").hasBegun(0);
    stage.speaker("Dave").in("kitchen").begins("turn on the oven").hasBegun(0);
    stage.speaker("Tom").in("livingroom").begins("set the volume of the stereo to 80").hasBegun(0);
    stage.speaker("Nobody").begins("turn on").isRefused("This home has no person Nobody");
  }

  @Test
  void aSentenceThatAnswersAScriptBeginsNothing(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    stage.begin("(askSomebody Dave \"Shall I wait with dinner?\" Rose)");
    dave.awaits("Shall I wait with dinner?");

    dave.begins("turn on the kitchen light").hasBegun(0).ends().isAnAnswer();
  }

  @Test
  void whatWasSaidLastCanBeUndone(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    dave.says("undo that").replies("There is nothing to undo.");

    dave.says("turn on the kitchen light and the bedroom light").isReached();
    dave.says("undo that").means("(cancel (:undo))").isReached();
    assertThat(stage.knowledge()).knows("(and (= (level kitchen-lamp) 0) (= (level bed-lamp) 0))");
  }
}
