package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;

/**
 * Scripts run beside each other unless they need the same: two persons want two discs of one stereo
 * (ADE, 5; A80). Each waits for who has it, and says who that is.
 */
@MaestroTest(home = "evening", scene = "evening", patience = 1500)
class OneStereoTest {

  private static final Duration WHILE_THE_FIRST_LISTENS = Duration.ofSeconds(60);

  @Test
  void theSecondDiscWaitsUntilTheFirstListenerIsDoneAndSaysWhoThatIs(Stage stage) {
    Pursuit rose = stage.begin("(listenTo 3 Rose)");
    stage.run(WHILE_THE_FIRST_LISTENS);
    Pursuit dave = stage.begin("(listenTo 2 Dave)");
    dave.awaitTelling("the player of stereo is held by G1.1");
    assertThat(stage.knowledge()).knows("(= (disc stereo) 3)");

    assertThat(rose.await()).isReached().neverTells("disc 2");
    GoalOutcome second = dave.await();
    assertThat(second).isReached().tells("stereo changes to disc 2");
    assertThat(second.duration()).isGreaterThan(Duration.ofMinutes(19));
    assertThat(stage.knowledge()).knows("(= (disc stereo) 2)");
  }

  @Test
  void whoOnlyWishesForADiscWaitsForTheListenerToo(Stage stage) {
    Pursuit rose = stage.begin("(listenTo 3 Rose)");
    stage.run(WHILE_THE_FIRST_LISTENS);
    Pursuit dave = stage.begin("(= (disc stereo) 2)");
    dave.awaitTelling("the player of stereo is held by G1.1");
    assertThat(stage.knowledge()).knows("(= (disc stereo) 3)");

    assertThat(rose.await()).isReached();
    assertThat(dave.await()).isReached();
    assertThat(stage.knowledge()).knows("(= (disc stereo) 2)");
  }

  @Test
  void whatNeedsSomethingElseOfTheStereoDoesNotWait(Stage stage) {
    Pursuit rose = stage.begin("(listenTo 3 Rose)");
    stage.run(WHILE_THE_FIRST_LISTENS);

    assertThat(stage.goal("(= (volume stereo) 55)")).isReached().tookAtMost(Duration.ofSeconds(10));
    assertThat(stage.goal("(switchedOn tv)")).isReached().tookAtMost(Duration.ofSeconds(10));
    assertThat(rose.await()).isReached();
    assertThat(stage.knowledge()).knows("(= (disc stereo) 3)");
  }
}
