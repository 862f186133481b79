package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.PricedFeature.ExactPrice;
import org.maestro.planning.api.Step;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** Whose price counts, and what a bad one does. */
class PricesTest {
  private final OptimalPlanner planner = new OptimalPlanner();

  private Plan plan(PlanningTask task) {
    PlanningResult result = planner.plan(task);
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    return ((PlanningResult.Found) result).plan();
  }

  private static SmallWorld bright() {
    return BobsHome.dark().facts("(= (illuminance zone-a) 100)", "(= (illuminance zone-b) 100)");
  }

  @Test
  void aLowerBoundIsMarkedUntilTheExactPriceIsGiven() {
    SmallWorld world =
        bright()
            .withdraw("cam-b")
            .offer("cam-b", "observeObject", new Price.Asked(SlParser.expression("1.5")));
    Plan guessed = plan(world.task("(canSee cam-b Cup)"));
    assertThat(guessed.cost()).isEqualTo(1.5);
    assertThat(guessed.steps().get(0).exactPrice()).isFalse();

    PricedFeature feature = world.offers.remove(world.offers.size() - 1);
    Map<String, Term> parameters = guessed.steps().get(0).bindings();
    world.offers.add(
        new PricedFeature(
            feature.member(),
            feature.type(),
            feature.price(),
            Map.of(parameters, new ExactPrice(4, 2.5))));
    Step exact = plan(world.task("(canSee cam-b Cup)")).steps().get(0);
    assertThat(exact.cost()).isEqualTo(4);
    assertThat(exact.seconds()).isEqualTo(2.5);
    assertThat(exact.exactPrice()).isTrue();
  }

  @Test
  void badPricesAreIgnored() {
    for (String price : List.of("-1", "(/ 1 0)", "(unheardOf ?self)")) {
      SmallWorld world = bright().offer("cam-c", "observeObject", "1");
      world.facts("(covers cam-c zone-b)").individuals("Thing Device", "cam-c");
      world.withdraw("cam-c").offer("cam-c", "observeObject", price);
      assertThat(plan(world.task("(canSee ?agent Cup)")).cost()).isEqualTo(2);
    }
  }

  @Test
  void priceExpressionsAreReadInTheStateBeforeTheStep() {
    SmallWorld world =
        BobsHome.words().individuals("Zone Place", "zone-b").facts("(= (illuminance zone-b) 0)");
    String price = "(+ 0.3 (* 2 (max 0 (- ?level (level ?self)))))";
    BobsHome.lamp(world, "lamp-1", 0.5, price, "(= (gain lamp-1 zone-b) 40)");
    assertThat(plan(world.task("(>= (illuminance zone-b) 20)")).cost()).isEqualTo(1.3);
    assertThat(plan(world.task("(= (level lamp-1) 0)")).cost()).isEqualTo(0.3);
  }

  @Test
  void aStepThatIsBarredOrNotOfferedAnyMoreIsNotValid() {
    SmallWorld world = bright();
    PlanningTask task = world.task("(canSee cam-b Cup)");
    List<Step> steps = plan(task).steps();
    assertThat(planner.revalidate(task, steps)).isPresent();
    PlanningTask barred =
        new PlanningTask(
            task.vocabulary(),
            task.facts(),
            task.features(),
            task.goal(),
            Set.of(steps.get(0).key()));
    assertThat(planner.revalidate(barred, steps)).isEmpty();
    assertThat(planner.revalidate(world.withdraw("cam-b").task("(canSee cam-b Cup)"), steps))
        .isEmpty();
    assertThat(planner.revalidate(bright().task("(in Cup zone-a)"), steps)).isEmpty();
    assertThat(
            planner.revalidate(
                bright().facts("(not (in Cup zone-b))").task("(canSee cam-b Cup)"), steps))
        .isEmpty();
  }
}
