package org.maestro.junit;

import static org.maestro.junit.MaestroAssertions.assertThat;

import org.junit.jupiter.api.Test;

/**
 * What is said in rooms whose agents listen, each with words of its own (ADE, 5; A13, A77, A87).
 */
@MaestroTest(home = "rooms", scene = "rooms")
class RoomsTest {
  private static final String PASTA = "Heat up the pasta from last night.";

  @Test
  void aRoomDoesWhatItUnderstands(Stage stage) {
    stage
        .speaker("Dave")
        .in("bedroom")
        .says("turn on the light")
        .isUnderstoodHere()
        .means("(initCNP (:goal (= (level bed-lamp) 1)))")
        .isReached();
  }

  @Test
  void whatItDoesNotUnderstandIsDoneByTheRoomThatDoes(Stage stage) {
    stage
        .speaker("Dave")
        .in("bedroom")
        .says(PASTA)
        .isPassedOnTo("kitchen-agent")
        .means("(initCNP (:goal (warm pasta)))")
        .isReached();

    assertThat(stage.knowledge()).knows("(warm pasta)");
  }

  @Test
  void aRoomWithoutWordsPassesAllOn(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("bathroom");

    dave.says("turn on the light")
        .isPassedOnTo("bedroom-agent")
        .means("(initCNP (:goal (= (level bath-lamp) 1)))")
        .isReached();
    dave.says("show the evening news").isPassedOnTo("living-agent").isReached();
  }

  @Test
  void whatAnotherRoomAsksBackIsAnsweredHere(Stage stage) {
    Speaker dave = stage.speaker("Dave").in("bedroom");

    dave.says("turn on the microwave").isPassedOnTo("kitchen-agent").isReached();
    dave.says("turn it off").isPassedOnTo("kitchen-agent").isReached();
  }

  /** The house agent fails: rooms carry on with what they have, and say what they cannot (A91). */
  @Test
  void withoutACentralAgentARoomDoesWhatItCanItself(Stage stage) {
    stage.platform().endAgent("CCA");

    Speaker dave = stage.speaker("Dave").in("bedroom");
    dave.says("turn on the light").isUnderstoodHere().isReached();
    dave.says("is the bedroom light on?").replies("Yes.");
    dave.says("undo that").isReached();
    assertThat(stage.knowledge()).knows("(= (level bed-lamp) 0)");
    dave.says(PASTA).isPassedOnTo("kitchen-agent").isReached();

    stage.platform().reviveCoordinator();
    dave.says("turn on the light").isReached();
  }

  @Test
  void whatNobodyUnderstandsIsSaidToBeSo(Stage stage) {
    stage.speaker("Dave").in("bedroom").says("sing the blues").isRefused("");
    stage.speaker("Dave").in("bathroom").says("fold the blorp").isRefused("blorp");
  }
}
