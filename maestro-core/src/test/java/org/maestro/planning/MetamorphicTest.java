package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What has to become of the cost of the cheapest plan when the home is changed in known ways. */
class MetamorphicTest {
  private static final double SAME = 1e-6;

  /** Above all costs. */
  private static final double NO_PLAN = 1e12;

  private final OptimalPlanner planner = new OptimalPlanner();

  @Property(tries = 40)
  void homes(@ForAll Random random) {
    check(OptimalityPropertyTest.homeTask(random), random);
  }

  @Property(tries = 60)
  void arbitraryFeatures(@ForAll Random random) {
    check(OptimalityPropertyTest.puzzleTask(random), random);
  }

  private void check(PlanningTask task, Random random) {
    PlanningResult before = planner.optimistic(task);
    double cost = cost(before);
    assertThat(cost(planner.optimistic(withDearerTwins(task)))).isCloseTo(cost, within(SAME));
    assertThat(cost(planner.optimistic(permuted(task, random)))).isCloseTo(cost, within(SAME));
    assertThat(cost(planner.optimistic(times(task, "7"))))
        .isCloseTo(cost < NO_PLAN ? 7 * cost : cost, within(7 * SAME));
    assertThat(cost(planner.optimistic(withCheaper(task, random))))
        .isLessThanOrEqualTo(cost + SAME);
    if (before instanceof PlanningResult.Found found && !found.plan().steps().isEmpty()) {
      String used = found.plan().steps().get(random.nextInt(found.plan().steps().size())).member();
      List<PricedFeature> others =
          task.features().stream().filter(feature -> !feature.member().equals(used)).toList();
      assertThat(cost(planner.optimistic(task.withFeatures(others))))
          .isGreaterThanOrEqualTo(cost - SAME);
    }
  }

  private static double cost(PlanningResult result) {
    return result instanceof PlanningResult.Found found ? found.plan().cost() : NO_PLAN;
  }

  /** A device of which nothing is known but that it does what any other does, at a higher price. */
  private static PlanningTask withDearerTwins(PlanningTask task) {
    List<PricedFeature> all = new ArrayList<>(task.features());
    task.features().forEach(feature -> all.add(priced("twin", feature, "(+ 1 %s)")));
    return task.withFeatures(all);
  }

  private static PlanningTask withCheaper(PlanningTask task, Random random) {
    List<PricedFeature> all = new ArrayList<>(task.features());
    int one = random.nextInt(all.size());
    all.set(one, priced(all.get(one).member(), all.get(one), "(* 0.5 %s)"));
    return task.withFeatures(all);
  }

  private static PlanningTask times(PlanningTask task, String factor) {
    return task.withFeatures(
        task.features().stream()
            .map(feature -> priced(feature.member(), feature, "(* " + factor + " %s)"))
            .toList());
  }

  private static PricedFeature priced(String member, PricedFeature feature, String change) {
    Expression cost = ((Price.Stated) feature.price()).cost();
    Expression changed = SlParser.expression(change.formatted(SlPrinter.print(cost)));
    return new PricedFeature(member, feature.type(), new Price.Stated(changed), Map.of());
  }

  private static PlanningTask permuted(PlanningTask task, Random random) {
    List<PricedFeature> features = new ArrayList<>(task.features());
    Collections.shuffle(features, random);
    return task.withFeatures(features).withFacts(new Reversed(task.facts()));
  }

  /** The same facts, with individuals in the contrary order. */
  private record Reversed(Facts facts) implements Facts {
    @Override
    public Truth truth(Formula.Atom atom) {
      return facts.truth(atom);
    }

    @Override
    public OptionalDouble number(Expression.Fluent fluent) {
      return facts.number(fluent);
    }

    @Override
    public Collection<Term.Name> individuals(String className) {
      List<Term.Name> reversed = new ArrayList<>(facts.individuals(className));
      Collections.reverse(reversed);
      return reversed;
    }
  }
}
