package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.lang.ref.WeakReference;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.SlParser;

/**
 * Whatever happens between two calls, the plan costs what one costs that was made without a memory.
 */
class ReplanningPlannerTest {
  private static final int HAPPENINGS = 6;

  private final OptimalPlanner fresh = new OptimalPlanner(20_000);

  @Property(tries = 40)
  void homes(@ForAll Random random) {
    follow(OptimalityPropertyTest.homeTask(random), random);
  }

  @Property(tries = 100)
  void arbitraryFeatures(@ForAll Random random) {
    follow(OptimalityPropertyTest.puzzleTask(random), random);
  }

  private void follow(PlanningTask first, Random random) {
    ReplanningPlanner planner = new ReplanningPlanner(fresh);
    List<PricedFeature> some = new ArrayList<>(first.features());
    String later = member(first, random);
    some.removeIf(f -> f.member().equals(later));
    PlanningTask task = some.isEmpty() || random.nextBoolean() ? first : first.withFeatures(some);
    for (int n = 0; n < HAPPENINGS; n++) {
      PlanningResult expected = fresh.solve(task);
      PlanningResult result = planner.solve(task);
      assertThat(result).hasSameClassAs(expected);
      if (result instanceof PlanningResult.Found found) {
        Plan plan = ((PlanningResult.Found) expected).plan();
        assertThat(found.atLeast()).isEqualTo(((PlanningResult.Found) expected).atLeast());
        assertThat(found.plan().cost()).isCloseTo(plan.cost(), within(1e-6));
        assertThat(fresh.revalidate(task, found.plan().steps()))
            .hasValueSatisfying(
                again -> assertThat(again.cost()).isCloseTo(plan.cost(), within(1e-6)));
        task = after(task, first, found.plan(), random);
      } else {
        task = task.withFeatures(first.features());
      }
    }
  }

  /** Steps that others wait for are checked again and again while things change around them. */
  @Property(tries = 60)
  void whatIsCheckedAgainIsAsItWouldBeHadItNeverBeenChecked(@ForAll Random random) {
    PlanningTask first = OptimalityPropertyTest.homeTask(random);
    if (!(fresh.solve(first) instanceof PlanningResult.Found found)) {
      return;
    }
    ReplanningPlanner planner = new ReplanningPlanner(fresh);
    List<Step> steps = found.plan().steps();
    PlanningTask task = first;
    for (int n = 0; n < HAPPENINGS; n++) {
      List<Step> rest = steps.subList(random.nextInt(Math.min(2, steps.size() + 1)), steps.size());
      Optional<Plan> again = planner.revalidate(task, rest);
      assertThat(again).isEqualTo(fresh.revalidate(task, rest));
      assertThat(planner.revalidate(task, rest)).isEqualTo(again);
      task =
          fresh.revalidate(task, steps).isPresent()
              ? after(task, first, found.plan(), random)
              : first;
    }
  }

  private static PlanningTask after(
      PlanningTask task, PlanningTask first, Plan plan, Random random) {
    List<PricedFeature> features = new ArrayList<>(task.features());
    switch (random.nextInt(7)) {
      case 0 -> features.removeIf(f -> f.member().equals(member(first, random)));
      case 1 -> features.remove(features.get(random.nextInt(features.size())));
      case 2 -> features.replaceAll(f -> random.nextInt(4) == 0 ? dearer(f, random) : f);
      case 3 -> {
        return task.withFeatures(first.features());
      }
      case 4 -> {
        Set<StepKey> barred = new HashSet<>(task.barred());
        plan.steps().stream().limit(1).forEach(step -> barred.add(step.key()));
        return task.withBarred(barred);
      }
      default -> {
        int done = random.nextInt(plan.steps().size() + 1);
        return task.withFacts(FactsAfter.steps(task, plan.steps().subList(0, done)));
      }
    }
    return features.isEmpty() ? task : task.withFeatures(features);
  }

  private static String member(PlanningTask task, Random random) {
    return task.features().get(random.nextInt(task.features().size())).member();
  }

  private static PricedFeature dearer(PricedFeature feature, Random random) {
    return priced(feature, String.valueOf(random.nextInt(5)));
  }

  /** Prices change with where a robot stands, for as long as a platform runs. */
  @Test
  void forgetsFeaturesThatWentLongAgo() {
    SmallWorld world = BobsHome.dark().facts("(in Cup zone-b)", "(in Bob zone-a)");
    PlanningTask task = world.task("(nextTo Cup Bob)");
    ReplanningPlanner planner = new ReplanningPlanner(fresh);
    List<WeakReference<PricedFeature>> went = new ArrayList<>();
    for (int round = 1; round <= 100; round++) {
      String price = String.valueOf(round / 1000.0);
      List<PricedFeature> dearer =
          task.features().stream().map(feature -> priced(feature, price)).toList();
      assertThat(planner.solve(task.withFeatures(dearer))).isInstanceOf(PlanningResult.Found.class);
      if (round <= 3) {
        dearer.forEach(feature -> went.add(new WeakReference<>(feature)));
      }
    }
    assertThat(went).hasSizeGreaterThan(20);
    await()
        .until(
            () -> {
              System.gc();
              return went.stream().allMatch(feature -> feature.get() == null);
            });
  }

  private static PricedFeature priced(PricedFeature feature, String price) {
    return new PricedFeature(
        feature.member(), feature.type(), new Price.Stated(SlParser.expression(price)), Map.of());
  }

  /** The rest of a plan that goes as expected stays the plan; nobody who left can better it. */
  @Test
  void keepsTheRestOfItsPlan() {
    SmallWorld world = BobsHome.dark().facts("(in Cup zone-b)", "(in Bob zone-a)");
    PlanningTask task = world.task("(nextTo Cup Bob)");
    ReplanningPlanner planner = new ReplanningPlanner(fresh);
    Plan plan = ((PlanningResult.Found) planner.solve(task)).plan();
    List<PricedFeature> others =
        task.features().stream().filter(f -> !f.member().startsWith("lamp")).toList();
    PlanningTask later =
        task.withFacts(FactsAfter.steps(task, plan.steps().subList(0, 1))).withFeatures(others);
    Plan rest = ((PlanningResult.Found) planner.solve(later)).plan();
    assertThat(rest.steps().stream().map(Step::key).toList())
        .isEqualTo(plan.steps().subList(1, plan.steps().size()).stream().map(Step::key).toList());
  }

  /** A dearer plan before lets more places be seen, and is no reason to begin at another one. */
  @Test
  void looksFirstWhereItWouldHadItNeverPlanned() {
    SmallWorld world = BobsHome.dark().facts("(in rose zone-a)", "(usuallyIn Cup zone-b)");
    PlanningTask known = world.copy().facts("(in Cup zone-b)").task("(in Cup zone-a)");
    PlanningTask unknown = world.task("(in Cup zone-a)");
    ReplanningPlanner planner = new ReplanningPlanner(fresh);
    planner.solve(known);

    Plan again = ((PlanningResult.Found) planner.solve(unknown)).plan();

    Plan first = ((PlanningResult.Found) fresh.solve(unknown)).plan();
    assertThat(again.steps().stream().map(Step::key).toList())
        .isEqualTo(first.steps().stream().map(Step::key).toList());
    assertThat(again.searches()).isEqualTo(first.searches());
  }
}
