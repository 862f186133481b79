package org.maestro.planning;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.IntFunction;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.PlanningResult.Obstacle;
import org.maestro.planning.PlanningResult.Obstacle.Kind;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Grounds a task backwards from its goal: a feature instance is made only when it changes something
 * that matters.
 */
final class Grounder {
  /**
   * What was grounded.
   *
   * @param beyond the budget from which on more instances may be of use; infinite when there are no
   *     more
   */
  record Grounded(GroundProblem problem, double beyond) {}

  private record Instance(int template, Map<String, Term> bindings) {}

  private final boolean forExplanation;
  private final Signature signature;
  private final OperatorFactory factory;
  private final Chances chances;
  private final StaticFacts facts;
  private final Variables variables;
  private final Offers offers;
  private final IntFunction<FeatureTemplate> templateMaker;
  private final Map<Integer, FeatureTemplate> templates = new HashMap<>();
  private final LeastPrice leastPrice;
  private final Map<PricedFeature, Double> leastPrices = new IdentityHashMap<>();
  private final GroundGoal goal;
  private final Map<Instance, List<Operator>> made = new HashMap<>();
  private final Map<Operator, Integer> templateOf = new HashMap<>();
  private final Map<Object, Map<Integer, List<Operator>>> changing = new HashMap<>();
  private CostAhead costAhead = new CostAhead(this::settingPrices);
  private PlanningTask task;

  Grounder(PlanningTask task) {
    this(task, task.features(), task.features(), false);
  }

  /**
   * @param changing features that tell what may change at all
   * @param offered those of which instances are made
   */
  private Grounder(
      PlanningTask task,
      List<PricedFeature> changing,
      List<PricedFeature> offered,
      boolean forExplanation) {
    this.task = task;
    this.forExplanation = forExplanation;
    this.signature = new Signature(task.vocabulary(), changing);
    this.offers = new Offers(offered);
    this.facts = new StaticFacts(task.facts());
    this.variables = new Variables(signature, facts);
    ConditionCompiler conditions = new ConditionCompiler(signature, facts, variables);
    ConditionCompiler preconditions = forExplanation ? conditions.keepingFailed() : conditions;
    this.factory = new OperatorFactory(variables, conditions, preconditions);
    this.chances = new Chances(signature, facts, conditions);
    EffectCompiler effects = new EffectCompiler(conditions, variables);
    Map<Formula, Map<List<Term>, Boolean>> staticAnswers = new HashMap<>();
    this.templateMaker =
        i ->
            new FeatureTemplate(
                offers.feature(i), signature, facts, preconditions, effects, staticAnswers);
    this.leastPrice = new LeastPrice(facts, signature);
    this.goal = GroundGoal.of(task.goal(), signature, facts, preconditions);
  }

  private FeatureTemplate template(int index) {
    FeatureTemplate known = templates.get(index);
    if (known == null) {
      known = templateMaker.apply(index);
      templates.put(index, known);
    }
    return known;
  }

  /**
   * Goes over to another task, for which all that was made stays as it is: the words and the goal
   * are the same, what steps may change is the same, and so is all that was asked of what they may
   * not.
   *
   * @return the atoms and fluents that are otherwise than in the task before; empty when too much
   *     is, and then this grounder is of no more use
   */
  Optional<Set<Object>> renew(PlanningTask next) {
    if (forExplanation
        || !next.goal().equals(task.goal())
        || !next.vocabulary().equals(task.vocabulary())
        || !signature.changesTheSameAs(new Signature(next.vocabulary(), next.features()))) {
      return Optional.empty();
    }
    Optional<Set<Object>> changed = facts.renew(next.facts(), signature);
    if (changed.isPresent()) {
      variables.renew();
      offers.become(next.features());
      if (!next.barred().equals(task.barred())) {
        changing.clear();
        made.clear();
      }
      costAhead = new CostAhead(this::settingPrices);
      task = next;
    }
    return changed;
  }

  /**
   * One that makes barred instances too, those of members that are not there, and those that are
   * impossible by what is stated, with conditions that say what is wrong.
   */
  static Grounder forExplanation(PlanningTask task) {
    List<PricedFeature> features = new ArrayList<>(task.features());
    task.unavailable().forEach(missing -> features.add(missing.feature()));
    return new Grounder(task, features, features, true);
  }

  /** One that makes these steps only. */
  static Grounder forSteps(PlanningTask task, List<Step> steps) {
    Set<List<String>> used = new HashSet<>();
    steps.forEach(step -> used.add(List.of(step.member(), step.feature().name())));
    List<PricedFeature> offered =
        task.features().stream()
            .filter(feature -> used.contains(List.of(feature.member(), feature.type().name())))
            .toList();
    return new Grounder(task, task.features(), offered, false);
  }

  /** What the atom or fluent, that was asked before, says something of; empty when it is static. */
  Optional<Object> variable(Object asked) {
    return asked instanceof Formula.Atom atom
        ? variables.known(atom).map(Object.class::cast)
        : Optional.of(variables.number((Expression.Fluent) asked));
  }

  /** Numbers of the task's features, which equal ones keep in other tasks. */
  Set<Integer> featuresThere() {
    return offers.there();
  }

  /** The task's features, as they are in operators: compared by identity. */
  Set<PricedFeature> present() {
    Set<PricedFeature> present = Collections.newSetFromMap(new IdentityHashMap<>());
    offers.there().forEach(number -> present.add(offers.feature(number)));
    return present;
  }

  GroundGoal goal() {
    return goal;
  }

  Chances chances() {
    return chances;
  }

  /** All feature instances that matter, whether they can ever be reached or not. */
  GroundProblem ground() {
    return ground(Double.POSITIVE_INFINITY).problem();
  }

  /**
   * The feature instances that a plan within the budget can use.
   *
   * @param budget cost units, from 0; infinite for all that matter
   */
  Grounded ground(double budget) {
    ChainCosts chains =
        new ChainCosts(
                this::changing,
                this::leastCost,
                Double.isFinite(budget) ? costAhead::of : operator -> 0,
                budget)
            .follow(goal.condition());
    Map<Object, List<Operator>> byTarget = byTarget(chains);
    Relevance relevance = new Relevance(target -> byTarget.getOrDefault(target, List.of()));
    relevance.close(goal.condition());
    return new Grounded(GroundProblem.reduced(relevance, goal), chains.beyond());
  }

  /** What the operator costs at least, in any state. */
  double leastCost(Operator operator) {
    return leastCost(operator.price(), operator.feature());
  }

  private double leastCost(StepPrice price, PricedFeature feature) {
    return price.cost() instanceof NumberExpression.Constant constant
        ? constant.number()
        : leastPrice(feature);
  }

  private Map<Integer, Double> settingPrices(Aim aim) {
    Map<Integer, Double> prices = new TreeMap<>();
    for (int template : offers.changing(aim.variable().predicate())) {
      PricedFeature feature = offers.feature(template);
      if (offers.mayBringAbout(feature.type(), aim)) {
        forEachInstance(
            template,
            aim,
            bindings ->
                prices.merge(
                    template, leastCost(factory.price(feature, bindings), feature), Math::min));
      }
    }
    return prices;
  }

  /** The instances that may bring about or change what is wanted. */
  private void forEachInstance(int template, Object want, Consumer<Map<String, Term>> consumer) {
    Object target = target(want);
    String name = name(target);
    List<Term> arguments =
        new ArrayList<>(
            target instanceof Variable variable
                ? variable.arguments()
                : ((NumberVariable) target).fluent().arguments());
    if (want instanceof Aim aim && aim.variable().functional()) {
      arguments.add(aim.variable().value(aim.value()));
    }
    template(template).forEachInstanceChanging(name, arguments, isSymmetric(name), consumer);
  }

  private static Object target(Object want) {
    return want instanceof Aim aim ? aim.variable() : want;
  }

  private boolean isSymmetric(String name) {
    return signature.declaration(name).map(PredicateDeclaration::symmetric).orElse(false);
  }

  private double leastPrice(PricedFeature feature) {
    return leastPrices.computeIfAbsent(feature, leastPrice::of);
  }

  /**
   * The operators of a given feature instance; empty when it is barred, not offered or impossible.
   */
  List<Operator> instances(StepKey key) {
    for (int i = 0; i < offers.numbers(); i++) {
      PricedFeature feature = offers.feature(i);
      if (offers.isThere(i)
          && feature.member().equals(key.member())
          && feature.type().name().equals(key.feature())
          && template(i).accepts(key.bindings())) {
        return made(i, key.bindings());
      }
    }
    return List.of();
  }

  private double changing(Object want, double left, List<Operator> into) {
    double cheapestLeftOut = Double.POSITIVE_INFINITY;
    for (int template : offers.changing(name(target(want)))) {
      PricedFeature feature = offers.feature(template);
      if (want instanceof Aim aim && !offers.mayBringAbout(feature.type(), aim)) {
        continue;
      }
      double price = leastPrice(feature);
      if (price <= left) {
        into.addAll(changing(want, template));
      } else {
        cheapestLeftOut = Math.min(cheapestLeftOut, price);
      }
    }
    return cheapestLeftOut;
  }

  private static String name(Object target) {
    return target instanceof Variable variable
        ? variable.predicate()
        : ((NumberVariable) target).fluent().name();
  }

  /** The operators of one feature that bring about or change what is wanted. */
  private List<Operator> changing(Object want, int template) {
    Map<Integer, List<Operator>> byTemplate =
        changing.computeIfAbsent(want, absent -> new TreeMap<>());
    List<Operator> known = byTemplate.get(template);
    if (known == null) {
      Set<Operator> found = new LinkedHashSet<>();
      forEachInstance(
          template,
          want,
          bindings ->
              made(template, bindings).stream()
                  .filter(operator -> changes(operator, want))
                  .forEach(found::add));
      known = List.copyOf(found);
      byTemplate.put(template, known);
    }
    return known;
  }

  /** By what they change, the features in their order. */
  private Map<Object, List<Operator>> byTarget(ChainCosts chains) {
    List<Operator> allowed = new ArrayList<>(chains.allowed());
    allowed.sort(Comparator.comparingInt(operator -> offers.rank(templateOf.get(operator))));
    return GroundProblem.byTarget(allowed);
  }

  private static boolean changes(Operator operator, Object want) {
    List<Change> changes = operator.changes();
    for (int i = 0; i < changes.size(); i++) {
      if (want instanceof Aim aim
          ? aim.isReachedBy(changes.get(i))
          : changes.get(i).target() == want) {
        return true;
      }
    }
    return false;
  }

  private List<Operator> made(int template, Map<String, Term> bindings) {
    Instance instance = new Instance(template, bindings);
    List<Operator> known = made.get(instance);
    if (known == null) {
      PricedFeature feature = offers.feature(template);
      StepKey key = new StepKey(feature.member(), feature.type().name(), bindings);
      known =
          forExplanation || !task.barred().contains(key)
              ? factory.operators(feature, bindings)
              : List.of();
      if (forExplanation) {
        known = known.stream().map(operator -> withWhatIsMissing(operator, template)).toList();
      }
      known.forEach(operator -> templateOf.put(operator, template));
      made.put(instance, known);
    }
    return known;
  }

  private Operator withWhatIsMissing(Operator operator, int template) {
    List<Condition> conditions = new ArrayList<>(List.of(operator.precondition()));
    if (task.barred().contains(operator.key())) {
      String reason =
          task.whyBarred().getOrDefault(operator.key(), "it failed twice with the same facts");
      conditions.add(missing(Kind.STEP, StepSentence.of(operator), reason, operator.key()));
    }
    int absent = template - task.features().size();
    if (absent >= 0) {
      Unavailable member = task.unavailable().get(absent);
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
            OptionalDouble.empty(),
            Optional.empty(),
            Optional.of(subject),
            List.of()));
  }
}
