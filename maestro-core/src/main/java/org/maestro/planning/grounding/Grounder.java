package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.planning.problem.ChainCosts;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundGoal;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Relevance;
import org.maestro.planning.problem.StaticFacts;
import org.maestro.planning.problem.StepSentence;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.problem.VariableValue;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Grounds a task backwards from its goal: a feature instance is made only when it changes something
 * that matters.
 */
public final class Grounder {
  /**
   * The result of grounding.
   *
   * @param beyond the budget from which on more instances may be of use; infinite when there are no
   *     more
   */
  public record Grounded(GroundProblem problem, double beyond) {}

  private final GroundingCache work;
  private final boolean usesBarred;
  private final GroundGoal goal;
  private final Set<Object> consulted = new HashSet<>();
  private CostAhead costAhead;
  private Set<StepKey> barred;

  public Grounder(PlanningTask task) {
    this(GroundingCache.forOnce(task), task, false);
  }

  /** One that makes use of what other goals left. */
  public Grounder(GroundingCache work, PlanningTask task) {
    this(work, task, false);
  }

  private Grounder(GroundingCache work, PlanningTask task, boolean usesBarred) {
    this.work = work;
    this.usesBarred = usesBarred;
    this.goal = work.goal(task.goal());
    this.costAhead = new CostAhead(prices());
    this.barred = task.barred();
  }

  /** The groundwork went over to another task for the same goal. */
  public void renew(PlanningTask next) {
    costAhead = new CostAhead(prices());
    barred = next.barred();
  }

  /**
   * One that makes barred instances too, those of members that are not there, and those that are
   * impossible by what is stated, with conditions that say what is wrong.
   */
  public static Grounder forExplanation(PlanningTask task) {
    List<PricedFeature> features = new ArrayList<>(task.features());
    IdentityHashMap<PricedFeature, Unavailable> missing = new IdentityHashMap<>();
    for (Unavailable unavailable : task.unavailable()) {
      features.add(unavailable.feature());
      missing.put(unavailable.feature(), unavailable);
    }
    GroundingCache work =
        new GroundingCache(
            task,
            StaticFacts.forOnce(task.facts()),
            features,
            features,
            true,
            made -> withWhatIsMissing(made, task, missing));
    return new Grounder(work, task, true);
  }

  /** One that makes these steps only. */
  public static Grounder forSteps(PlanningTask task, List<Step> steps) {
    return new Grounder(GroundingCache.forSteps(task, steps), task, false);
  }

  /** What the atom or fluent, that was asked before, says something of; empty when it is static. */
  public Optional<Object> variable(Object asked) {
    return asked instanceof Formula.Atom atom
        ? work.variables().known(atom).map(Object.class::cast)
        : Optional.of(work.variables().number((Expression.Fluent) asked));
  }

  /** Whether it was ever looked how a variable is at first. */
  public boolean hasConsulted(Object variable) {
    return consulted.contains(variable);
  }

  /** Numbers of the task's features, which equal ones keep in other tasks. */
  public Set<Integer> featuresThere() {
    return work.offers().there();
  }

  /** The task's features, as they are in operators: compared by identity. */
  public Set<PricedFeature> present() {
    Set<PricedFeature> present = Collections.newSetFromMap(new IdentityHashMap<>());
    featuresThere().forEach(number -> present.add(work.offers().feature(number)));
    return present;
  }

  public GroundGoal goal() {
    return goal;
  }

  public Chances chances() {
    return work.chances();
  }

  /** All feature instances that matter, whether they can ever be reached or not. */
  public GroundProblem ground() {
    return ground(Double.POSITIVE_INFINITY).problem();
  }

  /**
   * The feature instances that a plan within the budget can use.
   *
   * @param budget cost units, from 0; infinite for all that matter
   */
  public Grounded ground(double budget) {
    ChainCosts chains =
        new ChainCosts(
                this::changing,
                work::leastCost,
                Double.isFinite(budget) ? costAhead::of : (operator, left) -> 0,
                budget)
            .follow(goal.condition());
    consulted.addAll(chains.consulted());
    consulted.addAll(costAhead.consulted());
    Relevance relevance = new Relevance(GroundProblem.changing(inOrder(chains)));
    relevance.close(goal.condition());
    return new Grounded(GroundProblem.reduced(relevance, goal), chains.beyond());
  }

  private CostAhead.Source prices() {
    return new CostAhead.Source() {
      @Override
      public Map<Integer, Double> settingPrices(VariableValue aim) {
        return Grounder.this.settingPrices(aim);
      }

      @Override
      public Optional<OwnWays> ownWays(Variable variable) {
        return Grounder.this.ownWays(variable);
      }

      @Override
      public List<Operator> achievers(VariableValue aim) {
        List<Operator> achievers = new ArrayList<>();
        changing(aim, Double.POSITIVE_INFINITY, achievers);
        return achievers;
      }

      @Override
      public double leastCost(Operator operator) {
        return work.leastCost(operator);
      }

      @Override
      public int featureOf(Operator operator) {
        return work.templateOf(operator);
      }
    };
  }

  /** Of what is known now, and is changed by nobody but a member that it names. */
  private Optional<OwnWays> ownWays(Variable variable) {
    int first = variable.initialCode();
    if (!variable.functional() || first < 0) {
      return Optional.empty();
    }
    VariableValue now = new VariableValue(variable, first);
    List<OwnStep> steps = new ArrayList<>();
    Set<Integer> features = new HashSet<>();
    for (int template : work.mayChange(variable)) {
      PricedFeature feature = work.offers().feature(template);
      List<OwnStep> own =
          work.offers().mayBringAbout(feature.type(), now)
              ? work.ownSteps(variable, template)
              : List.of();
      if (!own.isEmpty()) {
        boolean isOfOther = !variable.arguments().contains(new Term.Name(feature.member()));
        if (isOfOther || !own.stream().allMatch(step -> step.to().isGround())) {
          return Optional.empty();
        }
        steps.addAll(own);
        features.add(template);
      }
    }
    return Optional.of(
        new OwnWays(variable.value(first), work.ownGraph(steps), Set.copyOf(features)));
  }

  private Map<Integer, Double> settingPrices(VariableValue aim) {
    Map<Integer, Double> prices = new TreeMap<>();
    for (int template : work.mayChange(aim)) {
      if (work.offers().mayBringAbout(work.offers().feature(template).type(), aim)) {
        OptionalDouble least = work.settingPrice(aim, template);
        least.ifPresent(price -> prices.put(template, price));
      }
    }
    return prices;
  }

  /**
   * The operators of a given feature instance; empty when it is barred, not offered or impossible.
   */
  public List<Operator> instances(StepKey key) {
    return !usesBarred && barred.contains(key) ? List.of() : work.instances(key);
  }

  private double changing(Object want, double left, List<Operator> into) {
    double cheapestLeftOut = Double.POSITIVE_INFINITY;
    Offers offers = work.offers();
    ChangersOfWant changers = work.changers(want);
    List<Integer> features = changers.features();
    for (int i = 0; i < features.size(); i++) {
      PricedFeature feature = offers.feature(features.get(i));
      if (!offers.mayBringAbout(feature.type(), want)) {
        continue;
      }
      double price = work.leastPrice(feature);
      if (price > left) {
        cheapestLeftOut = Math.min(cheapestLeftOut, price);
      } else if (usesBarred || barred.isEmpty()) {
        into.addAll(work.changing(want, changers, i));
      } else {
        work.changing(want, changers, i).stream()
            .filter(operator -> !barred.contains(operator.key()))
            .forEach(into::add);
      }
    }
    return cheapestLeftOut;
  }

  /** The features in their order. */
  private List<Operator> inOrder(ChainCosts chains) {
    List<Operator> allowed = new ArrayList<>(chains.allowed());
    allowed.sort(
        Comparator.comparingInt(operator -> work.offers().rank(work.templateOf(operator))));
    return allowed;
  }

  private static Operator withWhatIsMissing(
      Operator operator, PlanningTask task, IdentityHashMap<PricedFeature, Unavailable> missing) {
    List<Condition> conditions = new ArrayList<>(List.of(operator.precondition()));
    if (task.barred().contains(operator.key())) {
      String reason =
          task.whyBarred().getOrDefault(operator.key(), "it failed twice with the same facts");
      conditions.add(missing(Kind.STEP, StepSentence.of(operator), reason, operator.key()));
    }
    Unavailable member = missing.get(operator.feature());
    if (member != null) {
      String name = member.feature().member();
      conditions.add(missing(Kind.MEMBER, name, member.reason(), new StepKey(name, "", Map.of())));
    }
    return operator.withPrecondition(Condition.all(conditions));
  }

  private static Condition missing(Kind kind, String what, String why, StepKey subject) {
    return new Condition.Fixed(
        new Obstacle(
            kind,
            what,
            kind == Kind.MEMBER ? "present" : "done",
            why,
            Obstacle.Extent.KNOWN,
            OptionalDouble.empty(),
            Optional.empty(),
            Optional.of(subject),
            List.of()));
  }
}
