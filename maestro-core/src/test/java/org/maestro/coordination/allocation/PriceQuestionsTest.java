package org.maestro.coordination.allocation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult.Found;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Which prices are asked for after which plan. */
class PriceQuestionsTest {
  private static final FeatureType MOVE =
      new FeatureType(
          "move",
          "urn:move",
          false,
          "{self} moves",
          List.of(),
          List.of(),
          List.of(),
          SlParser.formula("(here ?self)"),
          SlParser.effect("(there ?self)", name -> false),
          Optional.empty(),
          false,
          Optional.empty(),
          OptionalDouble.empty(),
          Set.of(),
          List.of(),
          List.of(),
          new Price.Asked(SlParser.expression("0.5")),
          SlParser.expression("1"),
          Timing.USUAL,
          Reliability.USUAL,
          Optional.empty(),
          "move",
          Map.of());

  private final PriceQuestions questions = new PriceQuestions();

  private static Map<String, Term> to(int zone) {
    return Map.of("to", SlParser.term("zone-" + zone));
  }

  private static OpenPrice rival(String member, int zone) {
    return new OpenPrice(new StepKey(member, "move", to(zone)), MOVE, 0.5, 1);
  }

  private static Found plan(double cost, boolean exact, List<OpenPrice> rivals) {
    Step step = new Step(1, "rose", MOVE, to(0), cost, 1, exact, Set.of());
    return new Found(
        new Plan(List.of(step), cost, Map.of()), OptionalDouble.empty(), Set.of("rose"), rivals);
  }

  private static List<OpenPrice> rivalsOfMany(int count) {
    return IntStream.range(0, count).mapToObj(i -> rival("robot-" + i, i)).toList();
  }

  @Test
  void whatThePlanKnowsIsNotAskedFor() {
    assertThat(questions.next(plan(2, true, rivalsOfMany(3)))).isEmpty();
  }

  @Test
  void theOnesOfThePlanComeFirst() {
    assertThat(questions.next(plan(0.5, false, rivalsOfMany(2))))
        .extracting(price -> price.step().member())
        .containsExactly("rose", "robot-0", "robot-1");
  }

  @Test
  void eachPlanMoreAsksMoreOfTheOthers() {
    List<OpenPrice> rivals = rivalsOfMany(500);

    assertThat(questions.next(plan(0.5, false, rivals))).hasSize(1 + 8);
    assertThat(questions.next(plan(0.6, false, rivals))).hasSize(1 + 32);
    assertThat(questions.next(plan(0.7, false, rivals))).hasSize(1 + 128);
    assertThat(questions.next(plan(0.8, false, rivals))).hasSize(1 + 128);
  }

  @Test
  void nobodyIsAskedForMoreThanHeCanAnswer() {
    List<OpenPrice> rivals = IntStream.range(0, 50).mapToObj(i -> rival("tulip", i)).toList();
    questions.next(plan(0.5, false, rivals));
    questions.next(plan(0.6, false, rivals));

    assertThat(questions.next(plan(0.7, false, rivals))).hasSize(1 + 8);
  }

  @Test
  void afterThreePlansWhatIsNotKnownIsReckonedByTheLeastAnswer() {
    PricedFeature offer = new PricedFeature("tulip", MOVE, MOVE.cost(), Map.of());
    PricedFeature stated =
        new PricedFeature("daisy", MOVE, new Price.Stated(SlParser.expression("1")), Map.of());
    for (double cost : new double[] {0.5, 0.6, 0.7}) {
      assertThat(questions.isReckoned(rival("tulip", 1))).isFalse();
      questions.next(plan(cost, false, List.of()));
      questions.answered(rival("rose", 0), 4 - cost);
    }

    List<PricedFeature> reckoned = questions.reckoned(List.of(offer, stated));

    assertThat(reckoned.get(0).price())
        .isEqualTo(new Price.Asked(SlParser.expression("(max 0.5 3.3)")));
    assertThat(reckoned.get(1)).isEqualTo(stated);
    assertThat(questions.isReckoned(rival("tulip", 1))).isTrue();
  }

  @Test
  void afterTwoMoreItIsReckonedByTheMeanAnswer() {
    PricedFeature offer = new PricedFeature("tulip", MOVE, MOVE.cost(), Map.of());
    for (double answer : new double[] {2, 3, 3, 3, 4}) {
      questions.next(plan(answer, false, List.of()));
      questions.answered(rival("rose", 0), answer);
    }

    assertThat(questions.reckoned(List.of(offer)).get(0).price())
        .isEqualTo(new Price.Asked(SlParser.expression("(max 0.5 3)")));
  }

  @Test
  void whatWasReckonedIsNobodysWordThoughAnswersComeIn() {
    for (double answer : new double[] {2, 3, 4}) {
      questions.next(plan(answer, false, List.of()));
      questions.answered(rival("rose", 0), answer);
    }
    questions.reckoned(List.of());
    OpenPrice reckoned = new OpenPrice(new StepKey("tulip", "move", to(1)), MOVE, 2, 1);

    questions.answered(rival("daisy", 0), 1);

    assertThat(questions.isReckoned(reckoned)).isTrue();
  }

  @Test
  void whatRestsOnReckonedPricesIsNotCalledTheBest() {
    for (double cost : new double[] {0.5, 0.6, 0.7}) {
      assertThat(questions.proven(plan(cost, true, List.of())).atLeast()).isEmpty();
      questions.next(plan(cost, false, List.of()));
    }

    assertThat(questions.proven(plan(5, true, List.of())).atLeast()).hasValue(0.7);
    assertThat(questions.proven(plan(0.65, true, List.of())).atLeast())
        .as("never more than the plan itself costs")
        .hasValue(0.65);
  }
}
