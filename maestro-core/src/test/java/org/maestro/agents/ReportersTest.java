package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.maestro.agents.content.Words;
import org.maestro.sl.Content;

/** Whom the central agent believes what he reports of members and of goals (ADE, 3.1; A23). */
class ReportersTest {
  private static final Duration LONGEST = Duration.ofMinutes(1);

  @RegisterExtension static final SocietyExtension STAGE = new SocietyExtension("reporters");

  private Society society;
  private Actor stranger;

  @BeforeEach
  void gather() {
    society = STAGE.society();
    stranger = society.add("stranger", Actor.Part.at(1));
  }

  private void reports(String content) {
    stranger.tell(
        () ->
            stranger.send(
                stranger.message(
                    ACLMessage.INFORM,
                    stranger.cca(),
                    Words.parse(content).toArray(Content[]::new))));
  }

  private void assertRefused(String content) {
    int before = stranger.heard().size();
    reports(content);
    society.await(() -> stranger.heard().size() > before, LONGEST);
    assertThat(stranger.heard()).as(content).endsWith("refuse");
  }

  @Test
  void whoStandsForNoMemberBringsNoneAndTakesNoneAway() {
    assertRefused("(inform (:member usher) (:phase ready))");
    assertThat(society.cca.presentMembers()).containsExactly("stranger");
    society.add("usher", Actor.Part.at(1));
    for (String report :
        List.of(
            "(inform (:member usher) (:phase lost) (:reason \"stolen\"))",
            "(inform (:member usher) (:alert \"fire\") (:goal none))",
            "(inform (:member usher) (:feature greet) (:goal G1) (:release \"tired\"))",
            "(inform (:member usher) (:got voice))",
            "(inform (:goal G1 (greeted Bob)) (:state achieved))",
            "(inform (:goal usher-1 (greeted Bob)) (:state pursued))")) {
      assertRefused(report);
    }
    assertThat(society.cca.presentMembers()).containsExactlyInAnyOrder("stranger", "usher");
  }

  /** While the usher is at it, somebody else says that it is lost. */
  @Test
  void theStoryTellsOfAReportThatIsNotBelievedAndTheGoalIsReached() {
    Actor usher =
        society.add(
            "usher",
            Actor.Part.onOrder(
                (actor, order) -> {
                  actor.answer(order, ACLMessage.AGREE, "(perform)");
                  reports("(inform (:member usher) (:phase lost) (:reason \"stolen\"))");
                  actor.later(Duration.ofSeconds(1), () -> actor.done(order));
                }));
    Society.Outcome outcome = society.pursue("(greeted Bob)");
    assertThat(outcome.reached()).as(society.told()).isTrue();
    assertThat(usher.heard()).contains("request");
    assertThat(society.told())
        .contains("MISCONDUCT stranger does not speak for usher; its own agent does.")
        .doesNotContain("stolen");
    assertThat(society.leftover()).isEmpty();
  }
}
