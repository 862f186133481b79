package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;

/**
 * A survey is a script: what is answered decides what is asked next, and all answers are kept (ADE,
 * 3.3; A45).
 */
@MaestroTest(home = "livingroom", scene = "livingroom-evening")
class SurveyTest {
  private static final String WATCHED = "Did you watch what was on?";
  private static final String LIKED = "How did you like it?";
  private static final String BETTER = "What would you have liked better?";

  private static Pursuit begin(Stage stage, Speaker dave) {
    Pursuit survey = stage.begin("(survey Dave)");
    dave.awaits(WATCHED);
    return survey;
  }

  @Test
  void answersSkipAQuestion(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    Pursuit survey = begin(stage, dave);

    dave.says("3").isAnAnswer();
    dave.awaits("Thank you, Dave.");

    assertThat(survey.await()).isReached();
    assertThat(stage.platform().answers())
        .extracting(GivenAnswer::person, GivenAnswer::question, GivenAnswer::answer)
        .containsExactly(tuple("Dave", WATCHED, "no"));
  }

  @Test
  void whatFitsNoQuestionIsRefusedAndTheOthersAreAskedInTurn(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    Pursuit survey = begin(stage, dave);

    dave.says("most of it")
        .isRefused(
            "G1.1 is not answered by \"most of it\"; write one of all of it, a part of it, no.");
    dave.says("A part of it").isAnAnswer();
    dave.awaits(LIKED);
    dave.says("2.5").isRefused("write a number from 1 to 7, by steps of 1.");
    dave.says("8").isRefused("write a number from 1 to 7, by steps of 1.");
    dave.says("2").isAnAnswer();
    dave.awaits(BETTER);
    dave.says("Another film.").isAnAnswer();
    dave.awaits("Thank you, Dave.");

    assertThat(survey.await())
        .isReached()
        .tells(
            "Asks Dave: \"How did you like it?\" From 1 (not at all) to 7 (very much), by steps of")
        .tells("?liked is 2, as Dave has answered.");
    List<GivenAnswer> answers = stage.platform().answers();
    assertThat(answers)
        .extracting(GivenAnswer::script, GivenAnswer::question, GivenAnswer::answer)
        .containsExactly(
            tuple("survey", WATCHED, "a part of it"),
            tuple("survey", LIKED, "2"),
            tuple("survey", BETTER, "Another film."));
    assertThat(answers).extracting(GivenAnswer::at).isSorted();
  }

  @Test
  void whoLikedItIsNotAskedForMore(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    Pursuit survey = begin(stage, dave);

    dave.says("all of it").isAnAnswer();
    dave.awaits(LIKED);
    dave.says("4").isAnAnswer();
    dave.awaits("Thank you, Dave.");

    assertThat(survey.await()).isReached();
    assertThat(stage.platform().answers())
        .extracting(GivenAnswer::question)
        .containsExactly(WATCHED, LIKED);
  }
}
