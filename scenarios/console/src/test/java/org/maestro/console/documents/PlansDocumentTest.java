package org.maestro.console.documents;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.Words;

/** Plans and bids as the coordinator words them, and as programs get them. */
class PlansDocumentTest {
  private static List<Words> lines(String content) {
    return Words.parse(content).stream().map(Words::of).toList();
  }

  @Test
  void aPlanHasItsStepsWithWhatTheyNeedAndWhatBecameOfThem() {
    JsonNode plan =
        PlansDocument.of(
                "G1",
                lines(
                    """
                    (inform (:plan 2) (:asked 3.5) (:cause "it is dark") (:notAsked 4) (:made 4) (:purpose reach) (:cost 7.5) (:lasts 9)
                      (:steps
                        (:step (:number 1) (:text "rose picks up Cup") (:member rose) (:feature pick) (:after) (:cost 4) (:seconds 4)
                          (:start 0) (:state done) (:begun 4.1) (:ended 8.2))
                        (:step (:number 2) (:text "rose drives to zone-a") (:member rose) (:feature move) (:after 1) (:cost 3.5) (:seconds 5)
                          (:start 4) (:state failed) (:begun 8.3) (:ended 9) (:problem "rose: the way is shut"))))
                    """))
            .at("/plans/0");

    assertThat(plan.path("number").asInt()).isEqualTo(2);
    assertThat(plan.path("cause").asText()).isEqualTo("it is dark");
    assertThat(plan.path("not_asked").asInt()).isEqualTo(4);
    assertThat(plan.path("duration_s").asDouble()).isEqualTo(9);
    JsonNode second = plan.at("/steps/1");
    assertThat(plan.at("/steps/0/after")).isEmpty();
    assertThat(second.path("after")).extracting(JsonNode::asInt).containsExactly(1);
    assertThat(second.path("state").asText()).isEqualTo("failed");
    assertThat(second.path("problem").asText()).isEqualTo("rose: the way is shut");
    assertThat(plan.at("/steps/0/problem").isNull()).isTrue();
  }

  @Test
  void aRoundWithoutAPlanHasNoSteps() {
    JsonNode plan =
        PlansDocument.of("G1", lines("(inform (:plan 1) (:asked 3.5) (:notAsked 0))"))
            .at("/plans/0");

    assertThat(plan.path("made_s").isNull()).isTrue();
    assertThat(plan.path("purpose").isNull()).isTrue();
    assertThat(plan.path("steps")).isEmpty();
  }

  @Test
  void bidsArePricesOrReasons() {
    JsonNode bids =
        BidsDocument.of(
                "G1",
                OptionalInt.of(2),
                lines(
                    """
                    (inform (:step 1) (:member rose) (:feature pick) (:chosen true) (:answer exact) (:cost 4.2) (:seconds 4))
                    (inform (:member tim) (:feature pick) (:chosen false) (:answer refused) (:reason "no hand is free"))
                    """))
            .path("bids");

    assertThat(bids.at("/0/step").asInt()).isEqualTo(1);
    assertThat(bids.at("/0/cost").asDouble()).isEqualTo(4.2);
    assertThat(bids.at("/0/chosen").asBoolean()).isTrue();
    assertThat(bids.at("/1/step").isNull()).isTrue();
    assertThat(bids.at("/1/cost").isNull()).isTrue();
    assertThat(bids.at("/1/reason").asText()).isEqualTo("no hand is free");
  }
}
