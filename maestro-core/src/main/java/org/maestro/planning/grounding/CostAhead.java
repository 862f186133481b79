package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.problem.VariableValue;
import org.maestro.sl.Term;

/**
 * A lower bound on what a plan pays before it can use an operator: some step has to bring about
 * each condition that does not hold yet, and who has to be somewhere has to go all the way. What no
 * one feature can bring about together adds up.
 */
final class CostAhead {
  /** Where more features have to do with each other, two steps are hardly ever told apart. */
  private static final int MOST_COUNTED = 12;

  /** Knows which instances of features bring a value about. */
  interface Source {
    /**
     * The features that may bring it about.
     *
     * @return the least price of an instance, by the number of the feature
     */
    Map<Integer, Double> settingPrices(VariableValue aim);

    /** The ways of a variable that only its own member changes; empty for others. */
    Optional<OwnWays> ownWays(Variable variable);

    /** All steps that bring the value about. */
    List<Operator> achievers(VariableValue aim);

    /** In any state; cost units. */
    double leastCost(Operator operator);

    /** The number of the operator's feature. */
    int featureOf(Operator operator);
  }

  /** What a condition costs at least, and all features by which it may be brought about. */
  private record Way(double cost, Set<Integer> features) {}

  private record Need(VariableValue aim, Way way) {}

  /**
   * A step that brings an aim about.
   *
   * @param cost with what it needs itself, all counted
   * @param features of the step and of the ways to what it needs
   */
  private record LastStep(Operator operator, double cost, Set<Integer> features) {}

  /** The steps that bring an aim about. */
  private record LastSteps(List<LastStep> cheapestFirst, Map<Integer, List<Operator>> byFeature) {
    static LastSteps of(List<LastStep> steps) {
      List<LastStep> sorted = new ArrayList<>(steps);
      sorted.sort(Comparator.comparingDouble(LastStep::cost));
      Map<Integer, List<Operator>> byFeature = new HashMap<>();
      for (LastStep step : steps) {
        for (int feature : step.features()) {
          byFeature.computeIfAbsent(feature, absent -> new ArrayList<>()).add(step.operator());
        }
      }
      return new LastSteps(sorted, byFeature);
    }

    /** Those that have to do with any of the features; some of them twice. */
    List<Operator> having(Set<Integer> features) {
      List<Operator> having = new ArrayList<>();
      features.forEach(feature -> having.addAll(byFeature.getOrDefault(feature, List.of())));
      return having;
    }
  }

  private final Source source;
  private final Map<VariableValue, Way> ways = new HashMap<>();
  private final Map<Variable, Optional<OwnWays>> ownWays = new HashMap<>();
  private final Map<Operator, Double> known = new HashMap<>();
  private final Map<Operator, Double> knownInOrder = new HashMap<>();
  private final Map<Operator, List<Need>> unmet = new HashMap<>();
  private final Map<VariableValue, List<Operator>> achievers = new HashMap<>();
  private final Map<VariableValue, LastSteps> lastSteps = new HashMap<>();
  private final Set<Object> lookedAt = new HashSet<>();

  CostAhead(Source source) {
    this.source = source;
  }

  /**
   * What has to be paid before the operator can be used.
   *
   * @param left more than this need not be reckoned exactly
   * @return from 0, in cost units
   */
  double of(Operator operator, double left) {
    double inAnyOrder = known.computeIfAbsent(operator, this::inAnyOrder);
    return inAnyOrder > left
        ? inAnyOrder
        : Math.max(inAnyOrder, knownInOrder.computeIfAbsent(operator, this::inOrder));
  }

  private double inAnyOrder(Operator operator) {
    return together(unmet(operator), new HashSet<>());
  }

  /** What the conditions need that do not hold yet; the dearest first. */
  private List<Need> unmet(Operator operator) {
    return unmet.computeIfAbsent(operator, this::unmetAnew);
  }

  private List<Need> unmetAnew(Operator operator) {
    List<Need> needed = new ArrayList<>();
    operator.precondition().forEachLeaf(this::lookAt);
    for (Condition part : operator.precondition().conjuncts()) {
      if (part instanceof Condition.Literal literal
          && literal.question() == Condition.Question.IS
          && !literal.holdsFor(literal.variable().initialCode())) {
        VariableValue aim = new VariableValue(literal.variable(), literal.value());
        needed.add(new Need(aim, way(aim)));
      }
    }
    needed.sort(Comparator.comparingDouble((Need need) -> need.way().cost()).reversed());
    return List.copyOf(needed);
  }

  private void lookAt(Condition leaf) {
    if (leaf instanceof Condition.Literal literal) {
      lookedAt.add(literal.variable());
    }
  }

  /** The variables of which it mattered how they are at first. */
  Set<Object> consulted() {
    return lookedAt;
  }

  /**
   * What is needed by ways that have no feature in common.
   *
   * @param counted features that are paid for already; those of the ways are added
   */
  private static double together(List<Need> needed, Set<Integer> counted) {
    double sum = 0;
    for (Need need : needed) {
      if (Collections.disjoint(counted, need.way().features())) {
        counted.addAll(need.way().features());
        sum += need.way().cost();
      }
    }
    return sum;
  }

  /**
   * Who has to be at one place for the step before this one, and at another for this one, goes to
   * the one, and from there to the other: a robot to the cup, and with it to whom it is for.
   */
  private double inOrder(Operator operator) {
    double most = 0;
    for (Condition part : operator.precondition().conjuncts()) {
      if (part instanceof Condition.Literal literal
          && literal.question() == Condition.Question.IS) {
        Optional<OwnWays> own = ownWays(literal.variable());
        if (own.isPresent()) {
          most = Math.max(most, inOrder(operator, literal, own.get()));
        }
      }
    }
    return most;
  }

  private double inOrder(Operator operator, Condition.Literal place, OwnWays own) {
    double most = 0;
    for (Need need : unmet(operator)) {
      if (need.aim().variable() == place.variable()
          || !Collections.disjoint(need.way().features(), own.features())) {
        continue;
      }
      Set<Integer> counted = new HashSet<>(own.features());
      counted.addAll(need.way().features());
      double besides = together(unmet(operator), counted);
      double least = Double.POSITIVE_INFINITY;
      for (Operator before : achievers(need.aim())) {
        least = Math.min(least, by(before, need.aim(), place, own, counted, least));
      }
      most = Math.max(most, Double.isFinite(least) ? besides + least : 0);
    }
    return most;
  }

  /**
   * What is paid at least when the aim is brought about by this step for the first time.
   *
   * @param counted features that are paid for otherwise, and those of the ways from place to place
   * @param least so much and more need not be reckoned exactly
   */
  private double by(
      Operator before,
      VariableValue aim,
      Condition.Literal place,
      OwnWays own,
      Set<Integer> counted,
      double least) {
    double once = source.leastCost(before);
    Term to = place.variable().value(place.value());
    Optional<Term> from = required(before, place.variable());
    double sum = once + own.costTo(from.orElse(to));
    if (sum < least && from.isPresent()) {
      sum += own.between(from.get(), to);
    }
    if (sum >= least) {
      return sum;
    }
    double needed = together(unmet(before), new HashSet<>(counted));
    for (Need need : unmet(before)) {
      if (sum + needed < least && need.aim().variable() != place.variable()) {
        needed = Math.max(needed, byTwoSteps(need, aim, counted));
      }
    }
    return sum + needed;
  }

  /**
   * What a need costs at least with what the last step to it needs itself, where the aim does not
   * hold yet: what a robot carries, it cannot put down before it has it.
   */
  private double byTwoSteps(Need need, VariableValue aim, Set<Integer> counted) {
    if (counted.size() > MOST_COUNTED) {
      return 0;
    }
    LastSteps steps = lastSteps.computeIfAbsent(need.aim(), this::lastSteps);
    double least = Double.POSITIVE_INFINITY;
    for (Operator last : steps.having(counted)) {
      if (!asksFor(last, aim)) {
        double own = counted.contains(source.featureOf(last)) ? 0 : source.leastCost(last);
        least = Math.min(least, own + together(unmet(last), new HashSet<>(counted)));
      }
    }
    for (LastStep step : steps.cheapestFirst()) {
      if (step.cost() >= least) {
        break;
      }
      if (Collections.disjoint(step.features(), counted) && !asksFor(step.operator(), aim)) {
        least = step.cost();
      }
    }
    return Double.isFinite(least) ? least : 0;
  }

  private LastSteps lastSteps(VariableValue aim) {
    List<LastStep> steps = new ArrayList<>();
    for (Operator last : achievers(aim)) {
      Set<Integer> features = new HashSet<>(Set.of(source.featureOf(last)));
      unmet(last).forEach(need -> features.addAll(need.way().features()));
      double cost = source.leastCost(last) + together(unmet(last), new HashSet<>());
      steps.add(new LastStep(last, cost, features));
    }
    return LastSteps.of(steps);
  }

  private static boolean asksFor(Operator operator, VariableValue aim) {
    return required(operator, aim.variable())
        .equals(Optional.of(aim.variable().value(aim.value())));
  }

  private List<Operator> achievers(VariableValue aim) {
    return achievers.computeIfAbsent(aim, source::achievers);
  }

  /** The value that the operator asks for. */
  private static Optional<Term> required(Operator operator, Variable variable) {
    List<Condition> parts = operator.precondition().conjuncts();
    for (int i = 0; i < parts.size(); i++) {
      if (parts.get(i) instanceof Condition.Literal literal
          && literal.variable() == variable
          && literal.question() == Condition.Question.IS) {
        return Optional.of(variable.value(literal.value()));
      }
    }
    return Optional.empty();
  }

  private Optional<OwnWays> ownWays(Variable variable) {
    return ownWays.computeIfAbsent(variable, source::ownWays);
  }

  private Way way(VariableValue aim) {
    Way way = ways.get(aim);
    if (way == null) {
      way =
          ownWays(aim.variable())
              .map(own -> new Way(own.costTo(aim.variable().value(aim.value())), own.features()))
              .orElseGet(() -> byOneStep(aim));
      ways.put(aim, way);
    }
    return way;
  }

  private Way byOneStep(VariableValue aim) {
    Map<Integer, Double> prices = source.settingPrices(aim);
    return new Way(
        prices.values().stream().mapToDouble(price -> price).min().orElse(Double.POSITIVE_INFINITY),
        Set.copyOf(prices.keySet()));
  }
}
