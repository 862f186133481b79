package org.maestro.scenario;

import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.rats.member.Execution;
import org.maestro.rats.member.MemberProfile;
import org.maestro.rats.member.Procedure;
import org.maestro.rats.protocol.CostAnswer;

/**
 * Goals and devices in words that neither the code nor the plans know: a superclass, a
 * super-property of the home's own, a lamp that speaks SAREF (Three-layered architecture, 1, 2 and
 * 3.2.3; M7, M22, M63).
 */
@MaestroTest(home = "/homes/bob-own-words.ttl", scene = "bob-dark")
class UnknownWordsTest {

  private static final String SWITCH =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld",
         {"saref": "https://saref.etsi.org/core/", "domain": "https://w3id.org/maestro/domain#"}],
       "id": "https://example.org/shop#switch-1", "type": "saref:LightSwitch",
       "label": "the switch", "pose": "5.9 0.1 2.6", "luminousIntensity": 600,
       "domain:power": 1}
      """;

  @Test
  void aGoalOverASuperPropertyIsMetByWhatIsUnderIt(Stage stage) {
    GoalOutcome outcome = stage.goal("(withinReach Cup Bob)");

    assertThat(outcome).isReached().isConfirmed();
    assertThat(stage.world()).hasNextTo("Cup", "Bob");
  }

  @Test
  void aGoalOverASuperclassIsMetByWhatIsUnderIt(Stage stage) {
    GoalOutcome outcome = stage.goal("(exists (?x - Thing ?d - Sight) (canSee ?d ?x))");

    assertThat(outcome).isReached().tells("looks for");
  }

  @Test
  void aLampThatSpeaksSarefIsUsed(Stage stage) {
    stage.join(
        new MemberProfile(
            "switch-1",
            SWITCH,
            Set.of("calm", "busy"),
            "calm",
            Set.of("calm"),
            Map.of(
                "adjustLight",
                new MemberProfile.Feature(
                    "adjustLight",
                    Set.of(),
                    Set.of("light"),
                    false,
                    Optional.empty(),
                    "busy",
                    shining(stage)))),
        () -> List.of("(= (level switch-1) 0)"));
    stage.await("the switch", () -> stage.platform().presentMembers().contains("switch-1"));

    assertThat(stage.goal("(nextTo Cup Bob)")).isReached().tells("switch-1 is set to 1");
    assertThat(stage.world()).hasNextTo("Cup", "Bob").hasLampAt("lamp-b1", 0);
  }

  private static Procedure shining(Stage stage) {
    return new Procedure() {
      @Override
      public void start(Execution execution) {
        stage
            .clock()
            .schedule(
                Duration.ofMillis(300),
                "the switch",
                () -> {
                  stage.world().setAmbient("zone-b", 17 + 600 / (2.6 * 2.6));
                  execution.succeed(Map.of());
                });
      }

      @Override
      public CostAnswer cost(Map<String, Object> parameters) {
        return new CostAnswer(Optional.of(0.3), Optional.of(0.3), Optional.empty());
      }
    };
  }
}
