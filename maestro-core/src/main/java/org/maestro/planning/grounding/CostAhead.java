package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.VariableValue;

/**
 * A lower bound on what a plan pays before it can use an operator: some step has to bring about
 * each condition that does not hold yet. What no one feature can bring about together adds up.
 */
final class CostAhead {

  /** Knows which instances of features bring a value about. */
  interface Source {
    /**
     * The features that may bring it about.
     *
     * @return the least price of an instance, by the number of the feature
     */
    Map<Integer, Double> settingPrices(VariableValue aim);
  }

  /** The cheapest step to a condition, and all features that have such steps. */
  private record Way(double cost, Set<Integer> features) {}

  private final Source source;
  private final Map<VariableValue, Way> ways = new HashMap<>();
  private final Map<Operator, Double> known = new HashMap<>();

  CostAhead(Source source) {
    this.source = source;
  }

  /** From 0, in cost units. */
  double of(Operator operator) {
    return known.computeIfAbsent(operator, this::computed);
  }

  private double computed(Operator operator) {
    List<Way> needed = new ArrayList<>();
    for (Condition part : operator.precondition().conjuncts()) {
      if (part instanceof Condition.Literal literal
          && literal.question() == Condition.Question.IS
          && !literal.holdsFor(literal.variable().initialCode())) {
        needed.add(way(new VariableValue(literal.variable(), literal.value())));
      }
    }
    needed.sort(Comparator.comparingDouble(Way::cost).reversed());
    Set<Integer> counted = new HashSet<>();
    double sum = 0;
    for (Way way : needed) {
      if (Collections.disjoint(counted, way.features())) {
        counted.addAll(way.features());
        sum += way.cost();
      }
    }
    return sum;
  }

  private Way way(VariableValue aim) {
    Way way = ways.get(aim);
    if (way == null) {
      Map<Integer, Double> prices = source.settingPrices(aim);
      way =
          new Way(
              prices.values().stream().mapToDouble(price -> price).min().orElse(0),
              Set.copyOf(prices.keySet()));
      ways.put(aim, way);
    }
    return way;
  }
}
