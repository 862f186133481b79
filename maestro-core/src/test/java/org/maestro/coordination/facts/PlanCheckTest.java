package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.sl.SlParser;

/** Whether a plan is as good as it was when it was made. */
class PlanCheckTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final PlanCheck check = new PlanCheck(new OptimalPlanner());
  private List<Step> steps;

  @BeforeEach
  void plan() {
    steps =
        ((PlanningResult.Found) new OptimalPlanner().plan(task("(in Cup zone-a)", "2")))
            .plan()
            .steps();
    assertThat(steps)
        .extracting(step -> step.feature().name())
        .containsExactly("pick", "move", "place");
  }

  @Test
  void aPlanStaysGoodWhereNothingIsOtherwise() {
    assertThat(check.isGood(task("(in Cup zone-a)", "2"), steps)).isTrue();
    assertThat(check.blocked(task("(in Cup zone-a)", "2"), steps)).isEmpty();
  }

  @Test
  void aPlanThatBecomesDearerIsNotGoodThoughItCanBeDone() {
    assertThat(check.isGood(task("(in Cup zone-a)", "3"), steps)).isFalse();
    assertThat(check.isGood(task("(in Cup zone-a)", "1"), steps)).isTrue();
    assertThat(check.blocked(task("(in Cup zone-a)", "3"), steps)).isEmpty();
  }

  @Test
  void aPlanThatMissesItsGoalIsNotGoodThoughItCanBeDone() {
    assertThat(check.isGood(task("(in Cup zone-b)", "2"), steps)).isFalse();
    assertThat(check.blocked(task("(in Cup zone-b)", "2"), steps)).isEmpty();
  }

  @Test
  void theFirstStepThatCannotBeDoneIsNamed() {
    home.told("rose", "(in rose zone-a)");

    assertThat(check.isGood(task("(in Cup zone-a)", "2"), steps)).isFalse();
    assertThat(check.blocked(task("(in Cup zone-a)", "2"), steps)).contains(steps.get(0));
    assertThat(check.blocked(task("(in Cup zone-a)", "2"), steps.subList(1, 3)))
        .contains(steps.get(1));
  }

  @Test
  void aGoalThatHoldsNeedsNoStep() {
    assertThat(check.holds(task("(in Cup zone-a)", "2"))).isEmpty();
    assertThat(check.holds(task("(in Cup ?where)", "2")))
        .hasValueSatisfying(
            plan -> {
              assertThat(plan.steps()).isEmpty();
              assertThat(plan.goalBinding()).containsEntry("where", SlParser.term("zone-b"));
            });
  }

  private PlanningTask task(String goal, String price) {
    List<PricedFeature> features =
        home.home.devices().get("rose").features().stream()
            .map(
                type ->
                    new PricedFeature(
                        "rose", type, new Price.Stated(SlParser.expression(price)), Map.of()))
            .toList();
    return new PlanningTask(home.vocabulary, home.now(), features, home.formula(goal), Set.of());
  }
}
