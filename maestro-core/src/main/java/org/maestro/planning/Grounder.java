package org.maestro.planning;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.PlanningResult.Obstacle;
import org.maestro.planning.PlanningResult.Obstacle.Kind;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Grounds a task backwards from its goal: a feature instance is made only when it changes something
 * that matters.
 */
final class Grounder {
  private record Instance(int template, Map<String, Term> bindings) {}

  private final PlanningTask task;
  private final boolean forExplanation;
  private final Signature signature;
  private final OperatorFactory factory;
  private final Chances chances;
  private final List<FeatureTemplate> templates;
  private final GroundGoal goal;
  private final Map<Instance, List<Operator>> made = new HashMap<>();

  Grounder(PlanningTask task) {
    this(task, false);
  }

  private Grounder(PlanningTask task, boolean forExplanation) {
    this.task = task;
    this.forExplanation = forExplanation;
    List<PricedFeature> features = new ArrayList<>(task.features());
    if (forExplanation) {
      task.unavailable().forEach(missing -> features.add(missing.feature()));
    }
    this.signature = new Signature(task.vocabulary(), features);
    StaticFacts facts = new StaticFacts(task.facts());
    Variables variables = new Variables(signature, facts);
    ConditionCompiler conditions = new ConditionCompiler(signature, facts, variables);
    ConditionCompiler preconditions = forExplanation ? conditions.keepingFailed() : conditions;
    this.factory = new OperatorFactory(variables, conditions, preconditions);
    this.chances = new Chances(signature, facts, conditions);
    EffectCompiler effects = new EffectCompiler(conditions, variables);
    Map<Formula, Map<List<Term>, Boolean>> staticAnswers = new HashMap<>();
    this.templates =
        features.stream()
            .map(
                feature ->
                    new FeatureTemplate(
                        feature, signature, facts, preconditions, effects, staticAnswers))
            .toList();
    this.goal = GroundGoal.of(task.goal(), signature, facts, preconditions);
  }

  /**
   * One that makes barred instances too, those of members that are not there, and those that are
   * impossible by what is stated, with conditions that say what is wrong.
   */
  static Grounder forExplanation(PlanningTask task) {
    return new Grounder(task, true);
  }

  GroundGoal goal() {
    return goal;
  }

  Chances chances() {
    return chances;
  }

  /** All feature instances that matter, whether they can ever be reached or not. */
  GroundProblem ground() {
    Relevance relevance = new Relevance(this::operatorsChanging);
    relevance.close(goal.condition());
    return GroundProblem.reduced(relevance, goal);
  }

  /**
   * The operators of a given feature instance; empty when it is barred, not offered or impossible.
   */
  List<Operator> instances(StepKey key) {
    for (int i = 0; i < templates.size(); i++) {
      PricedFeature feature = templates.get(i).feature();
      if (feature.member().equals(key.member())
          && feature.type().name().equals(key.feature())
          && templates.get(i).accepts(key.bindings())) {
        return made(i, key.bindings());
      }
    }
    return List.of();
  }

  private Collection<Operator> operatorsChanging(Object target) {
    String name;
    List<Term> arguments;
    if (target instanceof Variable variable) {
      name = variable.predicate();
      arguments = variable.arguments();
    } else {
      NumberVariable number = (NumberVariable) target;
      name = number.fluent().name();
      arguments = number.fluent().arguments();
    }
    Optional<PredicateDeclaration> declaration = signature.declaration(name);
    boolean symmetric = declaration.map(PredicateDeclaration::symmetric).orElse(false);
    Set<Operator> found = new LinkedHashSet<>();
    for (int i = 0; i < templates.size(); i++) {
      int template = i;
      templates
          .get(i)
          .forEachInstanceChanging(
              name,
              arguments,
              symmetric,
              bindings ->
                  made(template, bindings).stream()
                      .filter(operator -> changes(operator, target))
                      .forEach(found::add));
    }
    return new ArrayList<>(found);
  }

  private static boolean changes(Operator operator, Object target) {
    return operator.changes().stream().anyMatch(change -> change.target() == target);
  }

  private List<Operator> made(int template, Map<String, Term> bindings) {
    Instance instance = new Instance(template, bindings);
    List<Operator> known = made.get(instance);
    if (known == null) {
      PricedFeature feature = templates.get(template).feature();
      StepKey key = new StepKey(feature.member(), feature.type().name(), bindings);
      known =
          forExplanation || !task.barred().contains(key)
              ? factory.operators(feature, bindings)
              : List.of();
      if (forExplanation) {
        known = known.stream().map(operator -> withWhatIsMissing(operator, template)).toList();
      }
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
