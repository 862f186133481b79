package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.AskedGoal;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** What a child may not have done is not done for it, and is for who may (ADE, 5; A85). */
@MaestroTest(home = "evening", scene = "evening", patience = 1500)
class ChildrenTest {

  private static GoalOutcome asked(Stage stage, String person, String goal) {
    return stage.begin(new AskedGoal(goal).speaker(Optional.of(person))).await();
  }

  @Test
  void theVolumeStaysWithinTheLimitAndWhoMayIsNamed(Stage stage) {
    assertThat(asked(stage, "Tom", "(= (volume stereo) 80)"))
        .isNotReached()
        .hasCalls(0)
        .isExplainedBy("Tom may set the volume of the stereo to at most 60")
        .isExplainedBy("Dave, Grandma or Rose may set it so")
        .isExplainedBy("volume-of-children in evening.ttl");
    assertThat(stage.knowledge()).knows("(= (volume stereo) 50)");

    assertThat(asked(stage, "Tom", "(= (volume stereo) 60)")).isReached();
    assertThat(asked(stage, "Dave", "(= (volume stereo) 80)")).isReached();
    assertThat(stage.knowledge()).knows("(= (volume stereo) 80)");
  }

  @Test
  void theOvenIsKeptFromAChildWhateverItIsAskedFor(Stage stage) {
    List<String> goals =
        List.of(
            "(switchedOn oven)",
            "(and (switchedOn tv) (switchedOn oven))",
            "(keep (switchedOn oven))",
            "(after 5 (switchedOn oven))",
            "(served Scotch Tom)",
            "(serveDrink Wine Tom)",
            "(not (locked front-door))");
    for (String goal : goals) {
      assertThat(asked(stage, "Tom", goal))
          .isNotReached()
          .hasCalls(0)
          .isExplainedBy("or Rose it may");
    }
    assertThat(stage.knowledge())
        .excludes("(switchedOn oven)")
        .excludes("(switchedOn tv)")
        .knows("(locked front-door)");

    assertThat(asked(stage, "Rose", "(switchedOn oven)")).isReached();
    assertThat(stage.goal("(not (locked front-door))")).isReached();
  }

  @Test
  void aPlanForAChildIsMadeOfWhatItMay(Stage stage) {
    assertThat(
            asked(
                stage,
                "Mia",
                "(exists (?a - Appliance) (and (switchedOn ?a) (not (= ?a refrigerator))))"))
        .isReached();
    assertThat(asked(stage, "Mia", "(>= (targetTemperature kidsroom) 23)")).isReached();
    assertThat(asked(stage, "Mia", "(>= (targetTemperature kidsroom) 24)"))
        .isNotReached()
        .hasCalls(0)
        .isExplainedBy("Mia may set the target temperature of the kids' room to at most 23");
  }

  @Test
  void nobodyIsAskedForOnBehalfOfWhomNobodyKnows(Stage stage) {
    assertThat(asked(stage, "Tomm", "(switchedOn tv)"))
        .isRefused()
        .isExplainedBy("This home has no person Tomm; write Tom, if that is meant");
  }
}
