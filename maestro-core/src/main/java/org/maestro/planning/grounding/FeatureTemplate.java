package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.ConditionCompiler;
import org.maestro.planning.problem.EffectCompiler;
import org.maestro.planning.problem.Signature;
import org.maestro.planning.problem.StaticFacts;
import org.maestro.sl.EffectTarget;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/**
 * An offered feature, ready to be bound: which values its parameters may take, which static
 * conditions tie them, and what its effect may change.
 */
final class FeatureTemplate {
  /** So many values are tried sooner than it is found out which of them can matter. */
  private static final int FEW_VALUES = 4;

  /** Instances that are kept; a camera has one for each thing in each of its zones. */
  private static final int FEW = 256;

  private static final List<Term> TRUTHS = List.of(new Term.Truth(true), new Term.Truth(false));

  private final PricedFeature feature;
  private final ConditionCompiler conditions;
  private final Map<String, List<Term>> domains = new LinkedHashMap<>();
  private final List<Conjunct> conjuncts = new ArrayList<>();
  private final List<Formula> required = new ArrayList<>();
  private final List<EffectTarget> targets;
  private final IdleParameters idle;
  private final Map<Set<String>, Next> nextOf = new HashMap<>();

  /** All instances, once they were asked for, where they are few. */
  private @Nullable List<Map<String, Term>> few;

  private boolean many;

  /**
   * A static part of the precondition.
   *
   * @param variables parameters of which it speaks
   * @param speaksOfSelf whether it depends on the member too
   * @param answers what it was found to be, by the values of all these; shared between templates
   */
  private record Conjunct(
      Formula formula,
      Set<String> variables,
      boolean speaksOfSelf,
      Map<List<Term>, Boolean> answers) {}

  /**
   * The parameter that is bound next.
   *
   * @param rest those that are open then
   * @param decided static conditions that are decided then
   * @param narrowing conditions that may tell with which values alone they can hold
   */
  private record Next(
      String parameter, Set<String> rest, List<Conjunct> decided, List<Formula> narrowing) {}

  /**
   * @param staticAnswers what static conditions were found to be, shared between templates
   */
  FeatureTemplate(
      PricedFeature feature,
      Signature signature,
      StaticFacts facts,
      ConditionCompiler conditions,
      EffectCompiler effects,
      Map<Formula, Map<List<Term>, Boolean>> staticAnswers) {
    this.feature = feature;
    this.conditions = conditions;
    this.idle = new IdleParameters(feature, signature, conditions, effects);
    Set<String> mentioned = mentioned(feature);
    for (List<Parameter> parameters : List.of(feature.type().inputs(), feature.type().binds())) {
      for (Parameter parameter : parameters) {
        if (!parameter.optional() || mentioned.contains(parameter.name())) {
          domains.put(parameter.name(), domain(parameter, facts));
        }
      }
    }
    collectStatic(feature.type().precondition(), signature, staticAnswers);
    this.targets = EffectTarget.of(feature.type().effect());
  }

  PricedFeature feature() {
    return feature;
  }

  private static Set<String> mentioned(PricedFeature feature) {
    Set<String> names = new LinkedHashSet<>(FreeVariables.of(feature.type().precondition()));
    names.addAll(FreeVariables.of(feature.type().effect()));
    names.addAll(FreeVariables.of(statedPrice(feature)));
    return names;
  }

  /**
   * The price's expression, a lower bound where only the member knows: of all calls that it takes
   * in the mean.
   */
  static Expression statedPrice(PricedFeature feature) {
    Expression once =
        feature.price() instanceof Price.Stated stated
            ? stated.cost()
            : ((Price.Asked) feature.price()).atLeast();
    double calls = feature.type().reliability().expectedCalls();
    return calls == 1
        ? once
        : new Expression.Arithmetic(
            Expression.Operator.TIMES,
            List.of(new Expression.OfTerm(new Term.Number(calls)), once));
  }

  private static List<Term> domain(Parameter parameter, StaticFacts facts) {
    if (!parameter.oneOf().isEmpty()) {
      return parameter.oneOf();
    }
    Set<Term> values = new LinkedHashSet<>();
    for (String type : parameter.types()) {
      values.addAll(type.equals("boolean") ? TRUTHS : facts.individuals(type));
    }
    return List.copyOf(values);
  }

  private void collectStatic(
      Formula formula, Signature signature, Map<Formula, Map<List<Term>, Boolean>> staticAnswers) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(operand -> collectStatic(operand, signature, staticAnswers));
      return;
    }
    required.add(formula);
    if (!signature.isDynamic(formula)) {
      Set<String> variables = new LinkedHashSet<>(FreeVariables.of(formula));
      boolean speaksOfSelf = variables.remove(Self.NAME);
      conjuncts.add(
          new Conjunct(
              formula,
              variables,
              speaksOfSelf,
              staticAnswers.computeIfAbsent(formula, absent -> new HashMap<>())));
    }
  }

  /**
   * Hands on the bindings under which the effect may change what is named, as far as the static
   * conditions allow.
   *
   * @param arguments those of the predicate or number, without the value of a functional one
   * @param symmetric whether the arguments may be swapped
   */
  void forEachInstanceChanging(
      String name, List<Term> arguments, boolean symmetric, Consumer<Map<String, Term>> consumer) {
    for (EffectTarget target : targets) {
      if (target.name().equals(name)) {
        bindAndEnumerate(target, arguments, consumer);
        if (symmetric && arguments.size() == 2) {
          bindAndEnumerate(target, List.of(arguments.get(1), arguments.get(0)), consumer);
        }
      }
    }
  }

  private void bindAndEnumerate(
      EffectTarget target, List<Term> arguments, Consumer<Map<String, Term>> consumer) {
    Map<String, Term> bindings = selfOnly();
    for (int i = 0; i < Math.min(arguments.size(), target.arguments().size()); i++) {
      Term pattern = target.arguments().get(i);
      Term value = arguments.get(i);
      if (pattern instanceof Term.Variable variable) {
        Term before = bindings.get(variable.name());
        List<Term> domain = domains.get(variable.name());
        if (before != null && !before.equals(value) || domain != null && !domain.contains(value)) {
          return;
        }
        if (domain != null) {
          bindings.put(variable.name(), value);
        }
      } else if (!pattern.equals(value)) {
        return;
      }
    }
    forEachInstance(bindings, consumer);
  }

  private Map<String, Term> selfOnly() {
    Map<String, Term> bindings = new HashMap<>();
    bindings.put(Self.NAME, new Term.Name(feature.member()));
    return bindings;
  }

  /** The parameters' values in the order in which they are declared. */
  List<Term> values(Map<String, Term> bindings) {
    List<Term> values = new ArrayList<>(domains.size());
    domains.keySet().forEach(name -> values.add(bindings.get(name)));
    return values;
  }

  /** The bindings with {@code self}, if they are possible ones for this feature's parameters. */
  boolean accepts(Map<String, Term> bindings) {
    Map<String, Term> all = selfOnly();
    all.putAll(bindings);
    return domains.keySet().equals(bindings.keySet())
        && domains.entrySet().stream()
            .allMatch(domain -> domain.getValue().contains(bindings.get(domain.getKey())))
        && conjuncts.stream().allMatch(conjunct -> holds(conjunct, all));
  }

  /** Where nothing is bound but the member the question is always the same, and asked for often. */
  private void forEachInstance(Map<String, Term> bindings, Consumer<Map<String, Term>> consumer) {
    if (bindings.size() > 1 || many) {
      enumerate(bindings, consumer);
      return;
    }
    if (few == null) {
      List<Map<String, Term>> all = new ArrayList<>();
      enumerate(
          bindings,
          instance -> {
            if (all.size() <= FEW) {
              all.add(instance);
            }
          });
      if (all.size() > FEW) {
        many = true;
        enumerate(bindings, consumer);
        return;
      }
      few = all;
    }
    few.forEach(consumer);
  }

  private void enumerate(Map<String, Term> bindings, Consumer<Map<String, Term>> consumer) {
    Set<String> open = new LinkedHashSet<>(domains.keySet());
    open.removeAll(bindings.keySet());
    for (Conjunct conjunct : conjuncts) {
      if (Collections.disjoint(conjunct.variables(), open) && !holds(conjunct, bindings)) {
        return;
      }
    }
    choose(open, bindings, consumer);
  }

  private void choose(
      Set<String> open, Map<String, Term> bindings, Consumer<Map<String, Term>> consumer) {
    if (open.isEmpty()) {
      Map<String, Term> ordered = new LinkedHashMap<>();
      domains.keySet().forEach(name -> ordered.put(name, bindings.get(name)));
      consumer.accept(Collections.unmodifiableMap(ordered));
      return;
    }
    if (open.size() == 1) {
      String last = open.iterator().next();
      Optional<Term> enough = idle.sufficientValue(last, domain(last), bindings);
      if (enough.isPresent()) {
        bindings.put(last, enough.get());
        choose(Set.of(), bindings, consumer);
        bindings.remove(last);
        return;
      }
    }
    Next next = nextOf.computeIfAbsent(open, this::next);
    for (Term value : values(next, bindings)) {
      bindings.put(next.parameter(), value);
      if (allHold(next.decided(), bindings)) {
        choose(next.rest(), bindings, consumer);
      }
    }
    bindings.remove(next.parameter());
  }

  /** Those of the domain with which what is required can hold, as far as that is told. */
  private List<Term> values(Next next, Map<String, Term> bindings) {
    List<Term> domain = domain(next.parameter());
    if (domain.size() <= FEW_VALUES) {
      return domain;
    }
    Optional<Set<Term>> narrowest = Optional.empty();
    for (Formula formula : next.narrowing()) {
      Optional<Set<Term>> own = conditions.candidates(formula, next.parameter(), bindings);
      if (own.isPresent() && (narrowest.isEmpty() || own.get().size() < narrowest.get().size())) {
        narrowest = own;
      }
    }
    return narrowest.map(among -> domain.stream().filter(among::contains).toList()).orElse(domain);
  }

  private List<Term> domain(String parameter) {
    return Objects.requireNonNull(domains.get(parameter));
  }

  private boolean allHold(List<Conjunct> decided, Map<String, Term> bindings) {
    for (int i = 0; i < decided.size(); i++) {
      if (!holds(decided.get(i), bindings)) {
        return false;
      }
    }
    return true;
  }

  private Next next(Set<String> open) {
    String next = mostTied(open);
    Set<String> rest = new LinkedHashSet<>(open);
    rest.remove(next);
    return new Next(
        next,
        rest,
        conjuncts.stream()
            .filter(c -> c.variables().contains(next))
            .filter(c -> Collections.disjoint(c.variables(), rest))
            .toList(),
        required.stream().filter(formula -> FreeVariables.of(formula).contains(next)).toList());
  }

  /**
   * The open parameter that the most static conditions decide on; the first of the smallest among
   * equals.
   */
  private String mostTied(Set<String> open) {
    String best = "";
    long bestTies = -1;
    boolean onlyIdle = open.stream().allMatch(idle::mayBeIdle);
    for (String name : open) {
      if (!onlyIdle && idle.mayBeIdle(name)) {
        continue;
      }
      long ties =
          conjuncts.stream()
              .filter(c -> c.variables().contains(name))
              .filter(
                  c -> c.variables().stream().noneMatch(v -> open.contains(v) && !v.equals(name)))
              .count();
      if (ties > bestTies || ties == bestTies && domain(name).size() < domain(best).size()) {
        best = name;
        bestTies = ties;
      }
    }
    return best;
  }

  private boolean holds(Conjunct conjunct, Map<String, Term> bindings) {
    List<Term> values = new ArrayList<>(conjunct.variables().size() + 1);
    for (String name : conjunct.variables()) {
      values.add(bindings.get(name));
    }
    if (conjunct.speaksOfSelf()) {
      values.add(bindings.get(Self.NAME));
    }
    Boolean known = conjunct.answers().get(values);
    if (known == null) {
      known = conditions.condition(conjunct.formula(), bindings) != Constant.FALSE;
      conjunct.answers().put(values, known);
    }
    return known;
  }
}
