package org.maestro.coordination.facts;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PricedFeature;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * The observations that are still needed before a goal may be called reached: of the things of
 * those goal atoms that are only expected, though an observation of positions could decide them, of
 * the numbers that are only reckoned, and of what was observed so long ago that somebody may have
 * changed it since. For planning, "seen" and "measured" are synthetic predicates that every sensing
 * of the thing or number brings about, and "touched" is what becomes of a thing of which a step
 * changes what could be seen: nothing is carried about only to be seen.
 */
public final class Confirmation {
  private static final String SEEN = "seen%";
  private static final String MEASURED = "measured%";
  private static final String TOUCHED = "touched%";

  private final SortedSet<String> things;
  private final List<Formula.Atom> facts;
  private final List<Expression.Fluent> numbers;
  private final SortedSet<String> reporters;
  private final List<Belief> objections;
  private final List<Belief> denials;
  private final List<Belief> missed;
  private final SortedSet<String> tellers;
  private final SortedSet<String> speakers;
  private final Optional<Instant> oldest;
  private final boolean outOfSight;

  private Confirmation(OnlyExpected expected) {
    this.things = expected.things();
    this.facts = expected.facts();
    this.numbers = expected.numbers();
    this.reporters = expected.reporters();
    this.objections = expected.objections();
    this.denials = expected.denials();
    this.missed = expected.missed();
    this.tellers = expected.tellers();
    this.speakers = expected.speakers();
    this.oldest = expected.oldest();
    this.outOfSight = expected.isOutOfSight();
  }

  /**
   * @param notBefore what was observed earlier does not count any more
   */
  public static Optional<Confirmation> needed(
      Formula goal, Map<String, Term> binding, Snapshot snapshot, Home home, Instant notBefore) {
    OnlyExpected expected = new OnlyExpected(snapshot, home, notBefore);
    expected.collect(new Substitution(binding).apply(goal));
    return expected.things().isEmpty() && expected.facts().isEmpty() && expected.numbers().isEmpty()
        ? Optional.empty()
        : Optional.of(new Confirmation(expected));
  }

  public SortedSet<String> things() {
    return things;
  }

  /** Who says by the deeds reported, or of itself, that it is so; nobody else does. */
  public SortedSet<String> reporters() {
    return reporters;
  }

  /** What others say against it, who are less sure. */
  public List<Belief> objections() {
    return objections;
  }

  /** What was observed since its doer said that it is so, and does not agree. */
  public List<Belief> denials() {
    return denials;
  }

  /**
   * What was observed since: a thing is not in the zone of the other that its doer put it beside,
   * or not in the one in which its doer says to have put it. It may lie just beyond, so other zones
   * are looked at before this counts.
   */
  public List<Belief> missed() {
    return missed;
  }

  /** Who tells of it of its own accord, and may yet have to. */
  public SortedSet<String> tellers() {
    return tellers;
  }

  /** Devices that have said of it how it is, or have reported a deed that makes it so. */
  public SortedSet<String> speakers() {
    return speakers;
  }

  /** It was seen; but others go on to say otherwise. */
  public boolean isOnlyDisputed() {
    return reporters.isEmpty() && !objections.isEmpty();
  }

  /** When the oldest of what was observed too long ago was observed, if there is any. */
  public Optional<Instant> oldest() {
    return oldest;
  }

  /** What is to be looked at though no position tells it. */
  public List<Formula.Atom> facts() {
    return facts;
  }

  /** Numbers to be measured. */
  public List<Expression.Fluent> numbers() {
    return numbers;
  }

  /**
   * The goal, and to have seen the things and observed the facts and numbers of which it speaks.
   */
  public Formula goal(Formula original) {
    List<Formula> parts = new ArrayList<>();
    parts.add(original);
    for (String thing : things) {
      parts.add(seen(new Term.Name(thing)));
      parts.add(new Formula.Not(new Formula.Atom(TOUCHED, List.of(new Term.Name(thing)))));
    }
    facts.forEach(fact -> parts.add(measured(fact.predicate(), fact.arguments())));
    numbers.forEach(number -> parts.add(measured(number.name(), number.arguments())));
    return new Formula.And(parts);
  }

  /** Whether effects of these kinds could let all be seen; if not, nobody has to be asked. */
  public boolean canBeSeenBy(List<Effect> effects) {
    Set<String> sensed = new TreeSet<>();
    effects.forEach(effect -> sensed.addAll(Sensing.names(effect)));
    return !outOfSight
        && (things.isEmpty() || effects.stream().anyMatch(Sensing::isOfAtoms))
        && facts.stream().map(Formula.Atom::predicate).allMatch(sensed::contains)
        && numbers.stream().map(Expression.Fluent::name).allMatch(sensed::contains);
  }

  /** That the thing has been seen. */
  static Formula.Atom seen(Term thing) {
    return new Formula.Atom(SEEN, List.of(thing));
  }

  static boolean isSeen(Formula.Atom atom) {
    return atom.predicate().equals(SEEN);
  }

  /** That it has been looked at, or measured, what the predicate or number is. */
  private static Formula.Atom measured(String name, List<Term> arguments) {
    return new Formula.Atom(MEASURED + name, arguments);
  }

  /** Whether the predicate is no matter of positions: these are seen with their things. */
  private static boolean isPlain(PredicateDeclaration declared) {
    return declared.observedWhen().isEmpty() && declared.derivedWhen().isEmpty();
  }

  public static Vocabulary extend(Vocabulary vocabulary) {
    Map<String, PredicateDeclaration> predicates = new TreeMap<>(vocabulary.predicates());
    List<TypedVariable> thing = List.of(new TypedVariable("x", Optional.empty()));
    predicates.put(SEEN, synthetic(SEEN, "has been seen", thing));
    predicates.put(TOUCHED, synthetic(TOUCHED, "is not as it was", thing));
    vocabulary.predicates().values().stream()
        .filter(Confirmation::isPlain)
        .forEach(
            declared ->
                predicates.put(
                    MEASURED + declared.name(),
                    synthetic(
                        MEASURED + declared.name(), "has been measured", declared.parameters())));
    return new Vocabulary(vocabulary.classes(), predicates, vocabulary.features());
  }

  private static PredicateDeclaration synthetic(
      String name, String label, List<TypedVariable> parameters) {
    return new PredicateDeclaration(
        name,
        name,
        label,
        parameters,
        false,
        false,
        false,
        false,
        Optional.<Duration>empty(),
        Map.of(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        OptionalDouble.empty(),
        Optional.empty());
  }

  public static PricedFeature extend(PricedFeature priced, Vocabulary vocabulary) {
    FeatureType type = priced.type();
    Effect extended = extend(type.effect(), vocabulary);
    return extended.equals(type.effect())
        ? priced
        : new PricedFeature(
            priced.member(), type.withEffect(extended), priced.price(), priced.exact());
  }

  /** The feature as its device knows it, without what {@link #extend} has added. */
  public static FeatureType described(FeatureType type) {
    return type.withEffect(described(type.effect()));
  }

  private static Effect described(Effect effect) {
    if (effect instanceof Effect.All all) {
      return new Effect.All(
          all.effects().stream()
              .filter(part -> !isOfWitnesses(part))
              .map(Confirmation::described)
              .toList());
    } else if (effect instanceof Effect.When when) {
      return new Effect.When(when.condition(), described(when.effect()));
    } else if (effect instanceof Effect.Forall forall) {
      return new Effect.Forall(forall.variables(), described(forall.effect()));
    }
    return effect;
  }

  private static boolean isOfWitnesses(Effect part) {
    return part instanceof Effect.Add add && isOfWitnesses(add.atom())
        || part instanceof Effect.Delete delete && isOfWitnesses(delete.atom());
  }

  private static boolean isOfWitnesses(Formula.Atom atom) {
    String name = atom.predicate();
    return name.equals(SEEN) || name.equals(TOUCHED) || name.startsWith(MEASURED);
  }

  /** What is sensed has been seen or measured; what is changed has to be measured again. */
  private static Effect extend(Effect effect, Vocabulary vocabulary) {
    if (effect instanceof Effect.All all) {
      return new Effect.All(all.effects().stream().map(part -> extend(part, vocabulary)).toList());
    } else if (effect instanceof Effect.When when) {
      return new Effect.When(when.condition(), extend(when.effect(), vocabulary));
    } else if (effect instanceof Effect.Forall forall) {
      return new Effect.Forall(forall.variables(), extend(forall.effect(), vocabulary));
    } else if (effect instanceof Effect.SenseAtom sense) {
      return looking(effect, sense.atom(), vocabulary);
    } else if (effect instanceof Effect.SenseNumber sense) {
      return new Effect.All(
          List.of(
              effect, new Effect.Add(measured(sense.fluent().name(), sense.fluent().arguments()))));
    } else if (effect instanceof Effect.Change change) {
      return new Effect.All(
          List.of(
              effect,
              new Effect.Delete(measured(change.fluent().name(), change.fluent().arguments()))));
    } else if (effect instanceof Effect.Add add) {
      return touching(effect, add.atom(), vocabulary);
    } else if (effect instanceof Effect.Delete delete) {
      return touching(effect, delete.atom(), vocabulary);
    }
    return effect;
  }

  private static Effect looking(Effect effect, Formula.Atom atom, Vocabulary vocabulary) {
    List<Effect> all = new ArrayList<>();
    all.add(effect);
    if (!atom.arguments().isEmpty()) {
      all.add(new Effect.Add(new Formula.Atom(SEEN, atom.arguments().subList(0, 1))));
    }
    if (vocabulary.predicate(atom.predicate()).filter(Confirmation::isPlain).isPresent()) {
      all.add(new Effect.Add(measured(atom.predicate(), atom.arguments())));
    }
    return new Effect.All(all);
  }

  /** What a step says of something that an observation could say too. */
  private static Effect touching(Effect effect, Formula.Atom atom, Vocabulary vocabulary) {
    Optional<PredicateDeclaration> declared = vocabulary.predicate(atom.predicate());
    if (declared.flatMap(PredicateDeclaration::observedWhen).isPresent()) {
      Formula.Atom touched = new Formula.Atom(TOUCHED, atom.arguments().subList(0, 1));
      return new Effect.All(List.of(effect, new Effect.Add(touched)));
    }
    return declared.filter(Confirmation::isPlain).isPresent()
        ? new Effect.All(
            List.of(effect, new Effect.Delete(measured(atom.predicate(), atom.arguments()))))
        : effect;
  }
}
