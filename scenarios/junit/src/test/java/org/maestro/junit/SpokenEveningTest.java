package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.api.Source;

/** What a family says in an evening is done in its house, and answered (ADE, 5). */
@MaestroTest(home = "evening", scene = "evening")
class SpokenEveningTest {

  /** A7: there is no place from where one has to speak. */
  @Test
  void theSameWordsMeanTheLightOfTheRoomInWhichTheyAreSaid(Stage stage) {
    stage.speaker("Dave").in("kitchen").says("turn on the light").isReached();
    stage.speaker("Grandma").in("bedroom").says("turn on the light").isReached();
    stage.speaker("Mia").in("hallway").says("turn on the light").isReached();

    assertThat(stage.knowledge())
        .knows("(= (level kitchen-lamp) 1)")
        .knows("(= (level bed-lamp) 1)")
        .knows("(= (level hall-lamp) 1)");
  }

  /** A10. */
  @Test
  void tenPercentOfFiftyAreFive(Stage stage) {
    stage
        .speaker("Dave")
        .in("livingroom")
        .says("Please increase the volume by 10%")
        .means("(initCNP (:goal (= (volume stereo) 55)))")
        .isReached();

    assertThat(stage.knowledge()).knows("(= (volume stereo) 55)");
  }

  /** A67. */
  @Test
  void whatWasNotHeardIsAskedForAndTheNumberAloneIsTheAnswer(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");

    dave.says("change to disc [unintelligible]").asks("What number should I change to?");
    dave.says("three").isReached();

    assertThat(stage.knowledge()).knows("(= (disc stereo) 3)");
  }

  /** A78. */
  @Test
  void whatIsAskedOfTheMusicIsAnswered(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");

    dave.says("What is the title of this track?").replies("Lullaby.");
    dave.says("How much time is remaining?").replies("A minute and 35 seconds.");
    dave.says("Are there other songs by this artist?")
        .replies(
            "Closedown, Disintegration, Fascination Street, Friday I'm in Love, High, Homesick,"
                + " Last Dance, Lovesong and six more.");
    dave.says("what time is it").replies("18:05.");
  }

  /** A79. */
  @Test
  void playersDoWhatTheyAreTold(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");

    dave.says("Turn up the volume").isReached();
    dave.says("Change to disc 3").isReached();
    dave.says("Switch to the satellite receiver and turn on the television.").isReached();

    assertThat(stage.knowledge())
        .knows("(= (volume stereo) 60)")
        .knows("(= (disc stereo) 3)")
        .knows("(source tv satellite)")
        .knows("(switchedOn tv)");
  }

  /** A82: it is the film after a film, and else it is asked. */
  @Test
  void whoWantedAFilmMeansTheFilmThatIsCalledAsTheBandIs(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");

    dave.says("Play the Cure.").asks("The artist or the film?");
    dave.says("Play the first Star Trek movie - no, actually, play the Cure.").isReached();

    assertThat(stage.knowledge()).knows("(playing tv TheCureFilm)");
  }

  /** A83: there are two cups on the counter, and one of them is red. */
  @Test
  void theRedCupIsBrought(Stage stage) {
    stage
        .speaker("Dave")
        .in("livingroom")
        .says("bring me the red cup")
        .means("(initCNP (:goal (nextTo cup-red Dave)))")
        .isReached();
  }

  /** Of A84, what the children are told, and nobody else. */
  @Test
  void theChildrenAreToldThatItIsTimeForDinner(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("livingroom");
    Speaker grandma = stage.speaker("Grandma").in("bedroom");
    Speaker tom = stage.speaker("Tom").in("kidsroom");
    Speaker mia = stage.speaker("Mia").in("bathroom");

    dave.says("let the kids know it's time for dinner").isReached();
    tom.awaits("it's time for dinner");
    mia.awaits("it's time for dinner");
    dave.hasHeardNothing();
    grandma.hasHeardNothing();
  }

  @Test
  void applesAreCountedAfterOneWasTaken(Stage stage) {
    stage
        .knowledge()
        .state(
            new Source(Source.Kind.STATED, "Rose"),
            Stream.of("apple-1", "apple-2", "apple-3")
                .map("(in %s refrigerator)"::formatted)
                .toList());
    Speaker dave = stage.speaker("Dave").in("kitchen");

    dave.says("How many apples are there in the refrigerator?").replies("Three.");
    dave.says("bring me an apple").isReached();
    assertThat(stage.world()).hasNextTo("apple-1", "Dave").hasInSight("apple-1");
    dave.says("How many apples are there in the refrigerator?").replies("Two.");
  }
}
