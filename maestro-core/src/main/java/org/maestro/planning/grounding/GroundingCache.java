package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.problem.ChainCosts;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.ConditionCompiler;
import org.maestro.planning.problem.Departure;
import org.maestro.planning.problem.EffectCompiler;
import org.maestro.planning.problem.GroundGoal;
import org.maestro.planning.problem.LeastPrice;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Signature;
import org.maestro.planning.problem.StaticFacts;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.problem.VariableValue;
import org.maestro.planning.problem.Variables;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * The part of grounding that no goal changes: variables, feature instances with their prices, and
 * which of them bring something about. Goals that are planned for one after the other share it, as
 * long as the same can be changed and all is so that cannot; members, prices and what steps can
 * change may be otherwise each time. For one thread at a time.
 */
public final class GroundingCache {
  /** Features that went; of each some ten kilobytes are kept. */
  private static final int SMALLEST_WASTE = 200;

  private static final int SIZE_OF_A_TEMPLATE = 4;

  private final PlanningTask origin;
  private final Signature signature;
  private final StaticFacts facts;
  private final Variables variables;
  private final Offers offers;
  private final ConditionCompiler conditions;
  private final ConditionCompiler preconditions;
  private final EffectCompiler effects;
  private final OperatorFactory factory;
  private final Chances chances;
  private final UnaryOperator<Operator> finish;
  private final Map<Formula, Map<List<Term>, Boolean>> staticAnswers = new HashMap<>();
  private final Map<Integer, FeatureTemplate> templates = new HashMap<>();
  private final LeastPrice leastPrice;
  private final IdentityHashMap<PricedFeature, Double> leastPrices = new IdentityHashMap<>();

  /** By family of features and the values of parameters: the same steps, whatever they cost. */
  private final Map<Integer, Map<List<Term>, Operator>> alike = new HashMap<>();

  private final Map<Integer, Map<List<Term>, List<Operator>>> made = new HashMap<>();
  private final IdentityHashMap<Operator, Integer> templateOf = new IdentityHashMap<>();
  private final Map<Integer, Map<Object, List<Operator>>> changing = new HashMap<>();
  private final Map<Integer, Map<VariableValue, OptionalDouble>> settingPrices = new HashMap<>();
  private final Map<Integer, Map<Variable, List<OwnStep>>> ownSteps = new HashMap<>();

  /** Robots that are alike have the same ways. */
  private final Map<List<OwnStep>, OwnGraph> ownGraphs = new HashMap<>();

  private final Map<String, ChangersByArgument> changers = new HashMap<>();
  private final Map<Object, ChangersOfWant> changersOfWants = new HashMap<>();

  /** How often all that was made of a feature was forgotten. */
  private final Map<Integer, Integer> versions = new HashMap<>();

  private final ChangeLog changes = new ChangeLog();
  private int generation;

  /** For the features of a task. */
  public GroundingCache(PlanningTask task) {
    this(task, new StaticFacts(task.facts()));
  }

  private GroundingCache(PlanningTask task, StaticFacts facts) {
    this(task, facts, task.features(), task.features(), false, operator -> operator);
  }

  /** For the features of a task, to be used for that task only. */
  static GroundingCache forOnce(PlanningTask task) {
    return new GroundingCache(task, StaticFacts.forOnce(task.facts()));
  }

  /**
   * @param facts of the task
   * @param changing features that tell what may change at all
   * @param offered those of which instances are made
   * @param keepingFailed whether instances that are impossible by what is stated are made too, with
   *     conditions that say what is wrong
   * @param finish what is done to each operator that was made
   */
  GroundingCache(
      PlanningTask task,
      StaticFacts facts,
      List<PricedFeature> changing,
      List<PricedFeature> offered,
      boolean keepingFailed,
      UnaryOperator<Operator> finish) {
    this.origin = task;
    this.finish = finish;
    this.signature = new Signature(task.vocabulary(), changing);
    this.offers = new Offers(offered, this::isSymmetric);
    this.facts = facts;
    this.variables = new Variables(signature, facts);
    this.conditions = new ConditionCompiler(signature, facts, variables);
    this.preconditions = keepingFailed ? conditions.keepingFailed() : conditions;
    this.effects = new EffectCompiler(conditions, variables);
    this.factory = new OperatorFactory(conditions, preconditions, effects);
    this.chances = new Chances(signature, facts, conditions);
    this.leastPrice = new LeastPrice(facts, signature);
  }

  /** Whether the same words mean the same, and the same can be changed, there. */
  public boolean suits(PlanningTask next) {
    return next.vocabulary().equals(origin.vocabulary())
        && signature.changesTheSameAs(new Signature(next.vocabulary(), next.features()));
  }

  /** Whether going over to these facts costs no more than asking what may be otherwise. */
  public boolean isNear(PlanningTask next) {
    return facts.isNear(next.facts());
  }

  /**
   * Goes over to another task that this suits. What steps can change may be otherwise there; where
   * what they cannot is, all instances are forgotten.
   *
   * @return false when there are others in the home, and then this is of no more use
   */
  public boolean renew(PlanningTask next) {
    boolean renewed = takeFacts(next.facts()).isPresent();
    if (renewed) {
      Map<Integer, Integer> before = offers.ranks();
      offers.become(next.features()).forEach(this::forgetPriced);
      if (!offers.ranks().equals(before)) {
        changersOfWants.clear();
      }
    }
    return renewed;
  }

  /**
   * Goes over to other facts.
   *
   * @return whether anything that was asked is otherwise in them; empty when there are others in
   *     the home, and then this is of no more use
   */
  public Optional<Boolean> takeFacts(Facts next) {
    Optional<StaticFacts.Difference> difference = facts.renew(next, signature);
    difference.ifPresent(
        found -> {
          if (found.ofWhatStays()) {
            forget();
          }
          variables.renew(found.changed());
          changes.add(found.changed());
        });
    return difference.map(found -> found.ofWhatStays() || !found.changed().isEmpty());
  }

  /** Each answer to a question for prices would leave instances behind that are of no more use. */
  private void forgetPriced(int template) {
    templates.remove(template);
    leastPrices.remove(offers.feature(template));
    made.getOrDefault(template, Map.of()).values().stream()
        .flatMap(List::stream)
        .forEach(templateOf::remove);
    made.remove(template);
    changing.remove(template);
    versions.merge(template, 1, Integer::sum);
    settingPrices.remove(template);
    ownSteps.remove(template);
  }

  private void forget() {
    conditions.forget();
    preconditions.forget();
    effects.forget();
    staticAnswers.clear();
    templates.clear();
    leastPrices.clear();
    ownSteps.clear();
    ownGraphs.clear();
    changers.clear();
    shed();
  }

  /** Forgets all instances; what they were made of is kept. */
  public void shed() {
    generation++;
    alike.clear();
    made.clear();
    templateOf.clear();
    changing.clear();
    settingPrices.clear();
    changersOfWants.clear();
  }

  /** Grows whenever all instances are forgotten: what was made of them is of no more use. */
  public int generation() {
    return generation;
  }

  /** What changes from task to task. */
  public ChangeLog changes() {
    return changes;
  }

  /** How much memory it takes, counted in instances. */
  public int size() {
    return templateOf.size() + SIZE_OF_A_TEMPLATE * templates.size() + facts.size() / 4;
  }

  /** Whether most of what is kept is of features that went. */
  public boolean isWorn() {
    return offers.numbers() > SMALLEST_WASTE + 4 * offers.there().size();
  }

  GroundGoal goal(Formula goal) {
    return GroundGoal.of(goal, signature, facts, preconditions);
  }

  Offers offers() {
    return offers;
  }

  Variables variables() {
    return variables;
  }

  Chances chances() {
    return chances;
  }

  /** The number of the feature of which the operator is an instance. */
  int templateOf(Operator operator) {
    return Objects.requireNonNull(templateOf.get(operator));
  }

  /** What the operator costs at least, in any state. */
  double leastCost(Operator operator) {
    return leastCost(operator.price().cost(), operator.feature());
  }

  private double leastCost(NumberExpression cost, PricedFeature feature) {
    return cost instanceof NumberExpression.Constant constant
        ? constant.number()
        : leastPrice(feature);
  }

  /** What an instance of the feature costs at least, in any state. */
  double leastPrice(PricedFeature feature) {
    return leastPrices.computeIfAbsent(feature, leastPrice::of);
  }

  /** What an instance costs at least that may bring it about; empty when there is none. */
  OptionalDouble settingPrice(VariableValue aim, int template) {
    return settingPrices
        .computeIfAbsent(template, absent -> new HashMap<>())
        .computeIfAbsent(aim, absent -> leastSettingPrice(aim, template));
  }

  private OptionalDouble leastSettingPrice(VariableValue aim, int template) {
    PricedFeature feature = offers.feature(template);
    boolean differ =
        !feature.exact().isEmpty() || !isConstant(FeatureTemplate.statedPrice(feature));
    double[] least = {Double.NaN};
    forEachInstance(
        template,
        aim,
        bindings -> {
          double price = leastCost(factory.cost(feature, bindings), feature);
          least[0] = Double.isNaN(least[0]) ? price : Math.min(least[0], price);
          return differ;
        });
    return Double.isNaN(least[0]) ? OptionalDouble.empty() : OptionalDouble.of(least[0]);
  }

  private static boolean isConstant(Expression price) {
    return price instanceof Expression.OfTerm of
        ? of.term() instanceof Term.Number
        : price instanceof Expression.Arithmetic arithmetic
            && arithmetic.operands().stream().allMatch(GroundingCache::isConstant);
  }

  /** The steps of one feature that give a functional variable another value. */
  List<OwnStep> ownSteps(Variable variable, int template) {
    return ownSteps
        .computeIfAbsent(template, absent -> new HashMap<>())
        .computeIfAbsent(variable, absent -> ownStepsAnew(variable, template));
  }

  OwnGraph ownGraph(List<OwnStep> steps) {
    return ownGraphs.computeIfAbsent(List.copyOf(steps), OwnGraph::new);
  }

  private List<OwnStep> ownStepsAnew(Variable variable, int template) {
    PricedFeature feature = offers.feature(template);
    List<OwnStep> steps = new ArrayList<>();
    template(template)
        .forEachValueStep(
            variable.predicate(),
            variable.arguments(),
            step ->
                steps.add(
                    new OwnStep(
                        step.from(),
                        step.to(),
                        leastCost(factory.cost(feature, step.bindings()), feature))));
    return List.copyOf(steps);
  }

  /**
   * The operators of one feature that bring about or change what is wanted.
   *
   * @param changers those of the want
   * @param index of the feature among them
   */
  List<Operator> changing(Object want, ChangersOfWant changers, int index) {
    return changers.operators(
        index,
        template -> versions.getOrDefault(template, 0),
        template -> changing(want, template));
  }

  private List<Operator> changing(Object want, int template) {
    Map<Object, List<Operator>> byWant =
        changing.computeIfAbsent(template, absent -> new HashMap<>());
    List<Operator> known = byWant.get(want);
    if (known == null) {
      Set<Operator> found = new LinkedHashSet<>();
      forEachInstance(
          template,
          want,
          bindings -> {
            made(template, bindings).stream()
                .filter(operator -> changes(operator, want))
                .forEach(found::add);
            return true;
          });
      known = List.copyOf(found);
      byWant.put(want, known);
    }
    return known;
  }

  private static boolean changes(Operator operator, Object want) {
    if (want instanceof Departure departure) {
      return departure.isBroughtAboutBy(operator);
    }
    List<Change> changes = operator.changes();
    for (int i = 0; i < changes.size(); i++) {
      if (want instanceof VariableValue aim
          ? aim.isReachedBy(changes.get(i))
          : changes.get(i).target() == want) {
        return true;
      }
    }
    return false;
  }

  /** The operators of a given feature instance; empty when it is not offered or impossible. */
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

  private List<Operator> made(int template, Map<String, Term> bindings) {
    Map<List<Term>, List<Operator>> byValues =
        made.computeIfAbsent(template, absent -> new HashMap<>());
    List<Term> values = template(template).values(bindings);
    List<Operator> known = byValues.get(values);
    if (known == null) {
      known = madeAnew(template, bindings, values);
      known.forEach(operator -> templateOf.put(operator, template));
      byValues.put(values, known);
    }
    return known;
  }

  private List<Operator> madeAnew(int template, Map<String, Term> bindings, List<Term> values) {
    PricedFeature feature = offers.feature(template);
    Map<List<Term>, Operator> family =
        alike.computeIfAbsent(offers.family(template), absent -> new HashMap<>());
    Operator same = family.get(values);
    if (same != null) {
      return factory.repriced(same, feature);
    }
    List<Operator> anew = factory.operators(feature, bindings).stream().map(finish).toList();
    anew.forEach(operator -> family.put(values, operator));
    return anew;
  }

  private FeatureTemplate template(int index) {
    FeatureTemplate known = templates.get(index);
    if (known == null) {
      known =
          new FeatureTemplate(
              offers.feature(index), signature, facts, preconditions, effects, staticAnswers);
      templates.put(index, known);
    }
    return known;
  }

  /** The instances that may bring about or change what is wanted. */
  private void forEachInstance(int template, Object want, Predicate<Map<String, Term>> consumer) {
    if (want instanceof Departure departure && departure.variable().functional()) {
      Variable variable = departure.variable();
      template(template)
          .forEachInstanceEnding(
              variable.predicate(),
              variable.arguments(),
              variable.value(departure.value()),
              consumer);
      return;
    }
    String name = name(want);
    template(template).forEachInstanceChanging(name, arguments(want), isSymmetric(name), consumer);
  }

  /** The numbers of the features that may bring about or change what is wanted. */
  List<Integer> mayChange(Object want) {
    return changers(want).features();
  }

  /** The same with the operators that do. */
  ChangersOfWant changers(Object want) {
    return changersOfWants.computeIfAbsent(
        want, absent -> new ChangersOfWant(mayChangeAnew(absent)));
  }

  private List<Integer> mayChangeAnew(Object want) {
    String name = name(want);
    List<Term> arguments = arguments(want);
    return offers.changing(
        name,
        arguments,
        all ->
            isSymmetric(name)
                ? all
                : changers
                    .computeIfAbsent(
                        name,
                        absent -> new ChangersByArgument(number -> template(number).reach(name)))
                    .of(all, arguments));
  }

  /** The arguments of what is wanted, with the value if that is wanted. */
  private static List<Term> arguments(Object want) {
    Object target = ChainCosts.target(want);
    if (!(target instanceof Variable variable)) {
      return ((NumberVariable) target).fluent().arguments();
    }
    if (!(want instanceof VariableValue aim) || !variable.functional()) {
      return variable.arguments();
    }
    List<Term> arguments = new ArrayList<>(variable.arguments());
    arguments.add(variable.value(aim.value()));
    return arguments;
  }

  /** The predicate or fluent of a want. */
  static String name(Object want) {
    Object target = ChainCosts.target(want);
    return target instanceof Variable variable
        ? variable.predicate()
        : ((NumberVariable) target).fluent().name();
  }

  private boolean isSymmetric(String name) {
    return signature.declaration(name).map(PredicateDeclaration::symmetric).orElse(false);
  }

  /** For the steps only, whatever else is offered. */
  public static GroundingCache forSteps(PlanningTask task, List<Step> steps) {
    Set<List<String>> used = new HashSet<>();
    steps.forEach(step -> used.add(List.of(step.member(), step.feature().name())));
    List<PricedFeature> offered =
        task.features().stream()
            .filter(feature -> used.contains(List.of(feature.member(), feature.type().name())))
            .toList();
    return new GroundingCache(
        task, new StaticFacts(task.facts()), task.features(), offered, false, operator -> operator);
  }
}
