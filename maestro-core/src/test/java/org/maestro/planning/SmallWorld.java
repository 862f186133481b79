package org.maestro.planning;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/** A world for tests: words, facts and offered features, stated in MAESTRO-SL. */
public final class SmallWorld implements Facts {
  final Map<String, PredicateDeclaration> predicates = new TreeMap<>();
  final Map<String, FeatureType> types = new LinkedHashMap<>();
  final List<PricedFeature> offers = new ArrayList<>();
  private final Map<String, String> seconds = new TreeMap<>();
  private final Map<String, Set<Term.Name>> members = new LinkedHashMap<>();
  private final Set<Term.Name> everybody = new LinkedHashSet<>();
  private final Map<Formula.Atom, Boolean> truths = new LinkedHashMap<>();
  private final Map<Expression.Fluent, Double> numbers = new LinkedHashMap<>();

  /** Another world that begins with the same words, facts and offers. */
  SmallWorld copy() {
    SmallWorld copy = new SmallWorld();
    copy.predicates.putAll(predicates);
    copy.types.putAll(types);
    copy.offers.addAll(offers);
    copy.members.putAll(members);
    copy.everybody.addAll(everybody);
    copy.truths.putAll(truths);
    copy.numbers.putAll(numbers);
    return copy;
  }

  /** All that may change, as a key. */
  String situation() {
    return truths + " " + numbers;
  }

  /** Predicates and fluents of which something else is known there. */
  Set<String> namesChangedSince(SmallWorld other) {
    Set<String> names = new LinkedHashSet<>();
    for (SmallWorld one : List.of(this, other)) {
      one.truths.keySet().stream()
          .filter(atom -> !Objects.equals(truths.get(atom), other.truths.get(atom)))
          .forEach(atom -> names.add(atom.predicate()));
      one.numbers.keySet().stream()
          .filter(fluent -> !Objects.equals(numbers.get(fluent), other.numbers.get(fluent)))
          .forEach(fluent -> names.add(fluent.name()));
    }
    return names;
  }

  public SmallWorld individuals(String classNames, String... names) {
    for (String name : names) {
      everybody.add(new Term.Name(name));
      for (String className : classNames.split(" ")) {
        members
            .computeIfAbsent(className, absent -> new LinkedHashSet<>())
            .add(new Term.Name(name));
      }
    }
    return this;
  }

  /** Flags: fluent, observable, functional, symmetric. */
  public SmallWorld word(String name, String flags, String... arguments) {
    return declare(name, flags, null, null, arguments);
  }

  SmallWorld derived(String name, String definition, String... arguments) {
    return declare(name, "", definition, null, arguments);
  }

  SmallWorld declare(
      String name, String flags, String derivedWhen, String likelyWhen, String... arguments) {
    List<TypedVariable> parameters = List.of(arguments).stream().map(SlParser::variable).toList();
    predicates.put(
        name,
        new PredicateDeclaration(
            name,
            "urn:" + name,
            name,
            parameters,
            flags.contains("fluent"),
            flags.contains("observable"),
            flags.contains("functional"),
            flags.contains("symmetric"),
            Optional.empty(),
            Map.of(),
            Optional.ofNullable(derivedWhen).map(SlParser::formula),
            Optional.empty(),
            Optional.ofNullable(likelyWhen).map(SlParser::formula),
            Optional.empty(),
            Optional.empty(),
            OptionalDouble.empty(),
            Optional.empty()));
    return this;
  }

  /** Seconds of a feature that is declared after this. */
  SmallWorld takes(String feature, String expression) {
    seconds.put(feature, expression);
    return this;
  }

  /**
   * Parameters: {@code zone:Zone target:Thing|Zone level=0,0.5,1}; after {@code ;} come the binds.
   */
  public SmallWorld feature(String name, String parameters, String precondition, String effect) {
    String[] parts = (parameters + " ; ").split(";");
    types.put(
        name,
        new FeatureType(
            name,
            "urn:" + name,
            false,
            "{self} does " + name,
            parameters(parts[0]),
            parameters(parts[1]),
            List.of(),
            SlParser.formula(precondition),
            SlParser.effect(effect, this::isFluent),
            Optional.empty(),
            false,
            Optional.empty(),
            OptionalDouble.empty(),
            Set.of(),
            List.of(),
            List.of(),
            new Price.Stated(SlParser.expression("1")),
            SlParser.expression(seconds.getOrDefault(name, "1")),
            Timing.USUAL,
            Reliability.USUAL,
            Optional.empty(),
            name,
            Map.of()));
    return this;
  }

  private static List<Parameter> parameters(String text) {
    List<Parameter> parameters = new ArrayList<>();
    for (String one : text.strip().split(" +")) {
      if (one.contains("=")) {
        String[] sides = one.split("=");
        List<Term> values = List.of(sides[1].split(",")).stream().map(SlParser::term).toList();
        parameters.add(new Parameter(sides[0], List.of("decimal"), values, List.of(), false));
      } else if (!one.isEmpty()) {
        String[] sides = one.split(":");
        List<String> classes = List.of(sides[1].split("\\|"));
        parameters.add(new Parameter(sides[0], classes, List.of(), List.of(), false));
      }
    }
    return parameters;
  }

  public SmallWorld offer(String member, String type, String price) {
    return offer(member, type, new Price.Stated(SlParser.expression(price)));
  }

  public SmallWorld offer(String member, String type, Price price) {
    offers.add(new PricedFeature(member, types.get(type), price, Map.of()));
    return this;
  }

  /** The member has said what this costs. */
  public SmallWorld told(
      String member, String type, Map<String, String> parameters, PricedFeature.ExactPrice price) {
    Map<String, Term> bindings = new LinkedHashMap<>();
    parameters.forEach((name, value) -> bindings.put(name, SlParser.term(value)));
    offers.replaceAll(
        offer -> {
          if (!offer.member().equals(member) || !offer.type().name().equals(type)) {
            return offer;
          }
          Map<Map<String, Term>, PricedFeature.ExactPrice> exact =
              new LinkedHashMap<>(offer.exact());
          exact.put(bindings, price);
          return new PricedFeature(member, offer.type(), offer.price(), exact);
        });
    return this;
  }

  SmallWorld withdraw(String member) {
    offers.removeIf(offer -> offer.member().equals(member));
    return this;
  }

  public SmallWorld facts(String... texts) {
    for (String text : texts) {
      Fact fact = SlParser.fact(text);
      if (fact instanceof Fact.Holds holds) {
        if (isFunctional(holds.atom().predicate())) {
          truths.keySet().removeIf(atom -> sameVariable(atom, holds.atom()));
        }
        truths.put(holds.atom(), true);
      } else if (fact instanceof Fact.Excluded excluded) {
        truths.put(excluded.atom(), false);
      } else if (fact instanceof Fact.Unknown unknown) {
        truths.remove(unknown.atom());
      } else if (fact instanceof Fact.Equation equation) {
        numbers.put(equation.fluent(), ((Term.Number) equation.value()).value());
      }
    }
    return this;
  }

  private boolean isFluent(String name) {
    return predicates.containsKey(name) && predicates.get(name).fluent();
  }

  private boolean isFunctional(String name) {
    return predicates.containsKey(name) && predicates.get(name).functional();
  }

  private static boolean sameVariable(Formula.Atom a, Formula.Atom b) {
    int last = a.arguments().size() - 1;
    return a.predicate().equals(b.predicate())
        && a.arguments().subList(0, last).equals(b.arguments().subList(0, last));
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    if (members.containsKey(atom.predicate())) {
      return Truth.of(members.get(atom.predicate()).contains(atom.arguments().get(0)));
    }
    PredicateDeclaration word = predicates.get(atom.predicate());
    if (word != null && word.derivedWhen().isPresent()) {
      Map<String, Term> bindings = new LinkedHashMap<>();
      for (int i = 0; i < word.parameters().size(); i++) {
        bindings.put(word.parameters().get(i).name(), atom.arguments().get(i));
      }
      return new Evaluation(this).truth(word.derivedWhen().get(), bindings);
    }
    Boolean known = truths.get(atom);
    if (known == null && word != null && word.symmetric()) {
      known =
          truths.get(
              new Formula.Atom(
                  atom.predicate(), List.of(atom.arguments().get(1), atom.arguments().get(0))));
    }
    if (known != null) {
      return Truth.of(known);
    }
    boolean other =
        word != null
            && word.functional()
            && truths.entrySet().stream()
                .anyMatch(e -> e.getValue() && sameVariable(e.getKey(), atom));
    return word != null && word.observable() && !other ? Truth.UNKNOWN : Truth.FALSE;
  }

  @Override
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    PredicateDeclaration word = predicates.get(atom.predicate());
    if (word == null || word.observable() || word.derivedWhen().isPresent()) {
      return Optional.empty();
    }
    Set<Term> found = new LinkedHashSet<>(everybody);
    truths.keySet().forEach(known -> found.addAll(known.arguments()));
    found.removeIf(
        term -> {
          Formula ground = new Substitution(Map.of(variable, term)).apply((Formula) atom);
          return truth((Formula.Atom) ground) == Truth.FALSE;
        });
    return Optional.of(found);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    Double number = numbers.get(fluent);
    return number == null ? OptionalDouble.empty() : OptionalDouble.of(number);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return className.isEmpty() ? everybody : members.getOrDefault(className, Set.of());
  }

  public PlanningTask task(String goal) {
    return new PlanningTask(
        new Vocabulary(Map.of(), predicates, types),
        this,
        List.copyOf(offers),
        SlParser.formula(goal),
        Set.of());
  }
}
