package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.ConditionCompiler;
import org.maestro.planning.problem.EffectCompiler;
import org.maestro.planning.problem.Signature;
import org.maestro.planning.problem.StaticFacts;
import org.maestro.sl.Effect;
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
  private final Map<String, Domain> domains = new LinkedHashMap<>();
  private final List<Conjunct> conjuncts = new ArrayList<>();

  /** Those that no domain makes sure of. */
  private final List<Conjunct> ties = new ArrayList<>();

  private final List<Formula> required = new ArrayList<>();
  private final List<Target> targets = new ArrayList<>();
  private final IdleParameters idle;
  private final Map<Set<String>, Next> nextOf = new HashMap<>();

  /** All instances, once they were asked for, where they are few. */
  private @Nullable List<Map<String, Term>> few;

  private boolean many;

  /**
   * An instance that gives a functional predicate a value.
   *
   * @param from the value that it has to have before; empty when it is not told
   * @param to a variable where that is not told by the parameters
   */
  record ValueStep(Optional<Term> from, Term to, Map<String, Term> bindings) {}

  /** A condition of a part of the effect. */
  private record Guard(Formula condition, Set<String> variables) {}

  /**
   * What a part of the effect names.
   *
   * @param guards that all have to hold for it
   */
  private record Target(EffectTarget named, List<Guard> guards) {
    String name() {
      return named.name();
    }

    List<Term> arguments() {
      return named.arguments();
    }
  }

  /** The values that a parameter may take, as far as they do not depend on other parameters. */
  private record Domain(List<Term> values, Set<Term> asSet) {
    Domain(List<Term> values) {
      this(values, new HashSet<>(values));
    }

    boolean contains(Term value) {
      return asSet.contains(value);
    }
  }

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
          domains.put(parameter.name(), new Domain(domain(parameter, facts)));
        }
      }
    }
    collectStatic(feature.type().precondition(), signature, staticAnswers);
    domains.replaceAll(this::narrowed);
    conjuncts.stream().filter(conjunct -> !isOfDomain(conjunct)).forEach(ties::add);
    collectTargets(feature.type().effect(), List.of());
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

  private void collectTargets(Effect effect, List<Guard> guards) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collectTargets(part, guards));
    } else if (effect instanceof Effect.When when) {
      List<Guard> more = new ArrayList<>(guards);
      more.add(new Guard(when.condition(), FreeVariables.of(when.condition())));
      collectTargets(when.effect(), more);
    } else if (effect instanceof Effect.Forall forall) {
      collectTargets(forall.effect(), guards);
    } else {
      EffectTarget.of(effect).forEach(one -> targets.add(new Target(one, guards)));
    }
  }

  private boolean isOfDomain(Conjunct conjunct) {
    return conjunct.variables().size() == 1 && domains.keySet().containsAll(conjunct.variables());
  }

  /** Each of many members asks for each of many values only once. */
  private Domain narrowed(String parameter, Domain domain) {
    List<Conjunct> own =
        conjuncts.stream().filter(c -> c.variables().equals(Set.of(parameter))).toList();
    if (own.isEmpty()) {
      return domain;
    }
    Map<String, Term> bindings = selfOnly();
    Optional<Set<Term>> among =
        own.stream()
            .map(conjunct -> conditions.candidates(conjunct.formula(), parameter, bindings))
            .flatMap(Optional::stream)
            .min(Comparator.comparingInt(Set::size));
    List<Term> left = new ArrayList<>();
    for (Term value : domain.values()) {
      Map<String, Term> all = new HashMap<>(bindings);
      all.put(parameter, value);
      if (among.map(some -> some.contains(value)).orElse(true) && allHold(own, all)) {
        left.add(value);
      }
    }
    return new Domain(List.copyOf(left));
  }

  /**
   * Hands on the bindings under which the effect may change what is named, as far as the static
   * conditions allow.
   *
   * @param arguments those of the predicate or number, without the value of a functional one
   * @param symmetric whether the arguments may be swapped
   * @param consumer says whether it wants more
   */
  void forEachInstanceChanging(
      String name, List<Term> arguments, boolean symmetric, Predicate<Map<String, Term>> consumer) {
    for (Target target : targets) {
      if (target.name().equals(name)) {
        boolean goesOn =
            bound(target, arguments).map(one -> forEachInstance(one, consumer)).orElse(true);
        if (goesOn && symmetric && arguments.size() == 2) {
          List<Term> swapped = List.of(arguments.get(1), arguments.get(0));
          goesOn = bound(target, swapped).map(one -> forEachInstance(one, consumer)).orElse(true);
        }
        if (!goesOn) {
          return;
        }
      }
    }
  }

  /**
   * The values that each argument can have where the effect changes what is named; empty for one of
   * which that is not told.
   */
  List<Optional<Set<Term>>> reach(String name) {
    List<Target> named = targets.stream().filter(target -> target.name().equals(name)).toList();
    int places = named.stream().mapToInt(target -> target.arguments().size()).min().orElse(0);
    return IntStream.range(0, places).mapToObj(place -> reach(named, place)).toList();
  }

  private Optional<Set<Term>> reach(List<Target> named, int place) {
    Set<Term> all = new HashSet<>();
    for (Target target : named) {
      Optional<Set<Term>> own = reach(target, target.arguments().get(place));
      if (own.isEmpty()) {
        return own;
      }
      all.addAll(own.get());
    }
    return Optional.of(all);
  }

  private Optional<Set<Term>> reach(Target target, Term pattern) {
    Map<String, Term> self = selfOnly();
    if (!(value(pattern, self) instanceof Term.Variable variable)) {
      return Optional.of(Set.of(value(pattern, self)));
    }
    Stream<Set<Term>> byDomain =
        Optional.ofNullable(domains.get(variable.name())).map(Domain::asSet).stream();
    Stream<Set<Term>> byGuards =
        target.guards().stream()
            .map(guard -> conditions.candidates(guard.condition(), variable.name(), self))
            .flatMap(Optional::stream);
    return Stream.concat(byDomain, byGuards).min(Comparator.comparingInt(Set::size));
  }

  /**
   * Hands on each way in which the effect may give a functional predicate another value.
   *
   * @param subject the arguments without the value
   */
  void forEachValueStep(String name, List<Term> subject, Consumer<ValueStep> consumer) {
    for (Target target : targets) {
      if (target.name().equals(name) && target.arguments().size() == subject.size() + 1) {
        bound(target, subject)
            .ifPresent(
                partly ->
                    forEachInstance(
                        partly,
                        bindings -> {
                          Map<String, Term> all = selfOnly();
                          all.putAll(bindings);
                          consumer.accept(
                              new ValueStep(
                                  patternBefore(name, subject, all).map(one -> value(one, all)),
                                  value(target.arguments().get(subject.size()), all),
                                  bindings));
                          return true;
                        }));
      }
    }
  }

  /**
   * Hands on the bindings under which the effect may end a value of a functional predicate.
   *
   * @param subject the arguments without the value
   */
  void forEachInstanceEnding(
      String name, List<Term> subject, Term value, Predicate<Map<String, Term>> consumer) {
    for (Target target : targets) {
      if (target.name().equals(name)) {
        bound(target, subject)
            .filter(bindings -> bindBefore(name, subject, value, bindings))
            .ifPresent(bindings -> forEachInstance(bindings, consumer));
      }
    }
  }

  /** Whether the step can be done where that is the value before it, as far as is told. */
  private boolean bindBefore(
      String name, List<Term> subject, Term value, Map<String, Term> bindings) {
    Optional<Term> pattern = patternBefore(name, subject, bindings);
    return pattern.isEmpty() || bind(pattern.get(), value, bindings);
  }

  /** The value that the step itself asks for, a variable perhaps; empty when it asks for none. */
  private Optional<Term> patternBefore(
      String name, List<Term> subject, Map<String, Term> bindings) {
    for (Formula formula : required) {
      if (formula instanceof Formula.Atom atom
          && atom.predicate().equals(name)
          && atom.arguments().size() == subject.size() + 1
          && atom.arguments().subList(0, subject.size()).stream()
              .map(argument -> value(argument, bindings))
              .toList()
              .equals(subject)) {
        return Optional.of(atom.arguments().get(subject.size()));
      }
    }
    return Optional.empty();
  }

  private static Term value(Term pattern, Map<String, Term> bindings) {
    return pattern instanceof Term.Variable variable
        ? bindings.getOrDefault(variable.name(), pattern)
        : pattern;
  }

  /** The parameters' values that give the target these arguments; empty when none do. */
  private Optional<Map<String, Term>> bound(Target target, List<Term> arguments) {
    Map<String, Term> bindings = selfOnly();
    for (int i = 0; i < Math.min(arguments.size(), target.arguments().size()); i++) {
      if (!bind(target.arguments().get(i), arguments.get(i), bindings)) {
        return Optional.empty();
      }
    }
    return isRuledOut(target, arguments, bindings) ? Optional.empty() : Optional.of(bindings);
  }

  /** A lamp changes the light of every zone that it shines upon, and of no other. */
  private boolean isRuledOut(Target target, List<Term> arguments, Map<String, Term> bindings) {
    if (target.guards().isEmpty()) {
      return false;
    }
    Map<String, Term> all = new HashMap<>(bindings);
    for (int i = 0; i < Math.min(arguments.size(), target.arguments().size()); i++) {
      if (target.arguments().get(i) instanceof Term.Variable variable) {
        Term value = arguments.get(i);
        Map<String, Term> others = Map.copyOf(all);
        if (target.guards().stream()
            .map(guard -> conditions.candidates(guard.condition(), variable.name(), others))
            .flatMap(Optional::stream)
            .anyMatch(among -> !among.contains(value))) {
          return true;
        }
        all.put(variable.name(), value);
      }
    }
    return target.guards().stream()
        .filter(guard -> all.keySet().containsAll(guard.variables()))
        .anyMatch(guard -> conditions.condition(guard.condition(), all) == Constant.FALSE);
  }

  private boolean bind(Term pattern, Term value, Map<String, Term> bindings) {
    if (!(pattern instanceof Term.Variable variable)) {
      return pattern.equals(value);
    }
    Term before = bindings.get(variable.name());
    Domain domain = domains.get(variable.name());
    if (before != null && !before.equals(value) || domain != null && !domain.contains(value)) {
      return false;
    }
    if (domain != null) {
      bindings.put(variable.name(), value);
    }
    return true;
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
            .allMatch(
                domain ->
                    domain
                        .getValue()
                        .contains(Objects.requireNonNull(bindings.get(domain.getKey()))))
        && ties.stream().allMatch(conjunct -> holds(conjunct, all));
  }

  /**
   * Where nothing is bound but the member the question is always the same, and asked for often.
   *
   * @param consumer says whether it wants more
   * @return the same
   */
  private boolean forEachInstance(
      Map<String, Term> bindings, Predicate<Map<String, Term>> consumer) {
    if (bindings.size() > 1 || many) {
      return enumerate(bindings, consumer);
    }
    if (few == null) {
      List<Map<String, Term>> all = new ArrayList<>();
      enumerate(
          bindings,
          instance -> {
            all.add(instance);
            return all.size() <= FEW;
          });
      if (all.size() > FEW) {
        many = true;
        return enumerate(bindings, consumer);
      }
      few = all;
    }
    return few.stream().allMatch(consumer);
  }

  private boolean enumerate(Map<String, Term> bindings, Predicate<Map<String, Term>> consumer) {
    Set<String> open = new LinkedHashSet<>(domains.keySet());
    open.removeAll(bindings.keySet());
    for (Conjunct conjunct : ties) {
      if (Collections.disjoint(conjunct.variables(), open) && !holds(conjunct, bindings)) {
        return true;
      }
    }
    return choose(open, bindings, consumer);
  }

  private boolean choose(
      Set<String> open, Map<String, Term> bindings, Predicate<Map<String, Term>> consumer) {
    if (open.isEmpty()) {
      Map<String, Term> ordered = new LinkedHashMap<>();
      domains.keySet().forEach(name -> ordered.put(name, bindings.get(name)));
      return consumer.test(Collections.unmodifiableMap(ordered));
    }
    if (open.size() == 1) {
      String last = open.iterator().next();
      Optional<Term> enough = idle.sufficientValue(last, domain(last), bindings);
      if (enough.isPresent()) {
        bindings.put(last, enough.get());
        boolean goesOn = choose(Set.of(), bindings, consumer);
        bindings.remove(last);
        return goesOn;
      }
    }
    Next next = nextOf.computeIfAbsent(open, this::next);
    boolean goesOn = true;
    for (Iterator<Term> values = values(next, bindings).iterator(); goesOn && values.hasNext(); ) {
      bindings.put(next.parameter(), values.next());
      if (allHold(next.decided(), bindings)) {
        goesOn = choose(next.rest(), bindings, consumer);
      }
    }
    bindings.remove(next.parameter());
    return goesOn;
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
    return Objects.requireNonNull(domains.get(parameter)).values();
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
        ties.stream()
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
