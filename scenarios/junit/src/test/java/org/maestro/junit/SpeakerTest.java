package org.maestro.junit;

import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

/** How a test speaks as persons of the home, and hears what they are told. */
@MaestroTest(home = "evening", scene = "evening")
class SpeakerTest {

  @Test
  void whatIsSaidIsDone(Stage stage) {
    stage
        .speaker("Dave")
        .in("kitchen")
        .says("Could you turn on the light, please?")
        .means("(initCNP (:goal (= (level kitchen-lamp) 1)))")
        .isReached();

    assertThat(stage.knowledge()).knows("(= (level kitchen-lamp) 1)");
  }

  @Test
  void aQuestionIsAnsweredAndOneBackIsAnsweredByWhatIsSaidNext(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");

    dave.says("is the stereo on?").means("(query-if (switchedOn stereo))").replies("Yes.");
    dave.says("turn on the lamp")
        .asks("Which lamp, the ceiling light, the floor lamp or the reading lamp?");
    dave.says("the floor lamp").isReached();
  }

  @Test
  void whatHasTheMostAndWhatThingsAreLikeIsTold(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("kitchen");

    dave.says("turn the kitchen light to 30 percent").isReached();
    dave.says("which is brighter, the kitchen light or the bedroom light?")
        .replies("The kitchen light.");
    dave.says("turn off the brightest lamp")
        .means("(initCNP (:goal (= (level kitchen-lamp) 0)))")
        .isReached();
    dave.says("what color is the red cup?").replies("Red.");
  }

  @Test
  void eachPersonHasOneConversation(Stage stage) {
    stage.speaker("Dave").in("kitchen").says("turn on the kitchen lamp").isReached();
    stage
        .speaker("Rose")
        .in("kitchen")
        .says("turn it off")
        .asks("I do not know what you mean by that.");

    stage
        .speaker("Dave")
        .in("livingroom")
        .says("turn it off")
        .means("(initCNP (:goal (= (level kitchen-lamp) 0)))");
  }

  @Test
  void whatAScriptAsksIsAnsweredAndWhatIsToldLaterIsHeard(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    stage.begin("(askSomebody Dave \"Shall I wait with dinner?\" Rose)");

    dave.awaits("Shall I wait with dinner?");
    dave.says("Yes, half an hour.").isAnAnswer();
    stage.speaker("Rose").awaits("Dave says: Yes, half an hour.");
    stage.begin("(after 1800 (tell Dave \"Dinner is ready.\"))");
    dave.awaits("Dinner is ready.").after(Duration.ofMinutes(30));
  }

  @Test
  void nobodyElseIsHeard(Stage stage) {
    stage.speaker("Dav").says("turn on the light").isRefused("write Dave, if that is meant");
    stage.speaker("Dave").in("attic").says("hello").isRefused("This home has no room attic");

    assertThatThrownBy(() -> stage.speaker("Dave").says("blorp").replies("Yes."))
        .hasMessageContaining("blorp");
  }
}
