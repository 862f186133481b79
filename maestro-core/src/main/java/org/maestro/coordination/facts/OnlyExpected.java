package org.maestro.coordination.facts;

import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.belief.AsClaimed;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * The grounds of a goal that holds that have no witness of late, or that a witness denies: things
 * whose place is only expected, disputed or was seen too long ago, other facts of which only their
 * doer tells, and numbers that are only reckoned, told by who made them, or were measured too long
 * ago. Sources of numbers differ always a little; of these the surer counts.
 */
final class OnlyExpected {
  static final String POSITION = "position";

  private final Snapshot snapshot;
  private final Home home;
  private final Vocabulary vocabulary;
  private final Testimony testimony;
  private final SortedSet<String> things = new TreeSet<>();
  private final Set<Formula.Atom> facts = new LinkedHashSet<>();
  private final Set<Expression.Fluent> numbers = new LinkedHashSet<>();
  private final SortedSet<String> reporters = new TreeSet<>();
  private final Set<Belief> objections = new LinkedHashSet<>();
  private final Set<Belief> denials = new LinkedHashSet<>();
  private final Set<Belief> missed = new LinkedHashSet<>();
  private final SortedSet<String> tellers = new TreeSet<>();
  private final SortedSet<String> speakers = new TreeSet<>();
  private Optional<Instant> oldest = Optional.empty();
  private boolean outOfSight;

  /**
   * @param notBefore what was observed earlier has to be observed again: anybody may have changed
   *     it since
   */
  OnlyExpected(Snapshot snapshot, Home home, Instant notBefore) {
    this.snapshot = snapshot;
    this.home = home;
    this.vocabulary = home.vocabulary();
    this.testimony = new Testimony(snapshot, home, notBefore);
  }

  SortedSet<String> things() {
    return things;
  }

  /** Of which no position tells whether they hold. */
  List<Formula.Atom> facts() {
    return List.copyOf(facts);
  }

  List<Expression.Fluent> numbers() {
    return List.copyOf(numbers);
  }

  /** Whose deeds, or whose word of themselves, let it be expected. */
  SortedSet<String> reporters() {
    return reporters;
  }

  /** What others have said since what is believed, and what contradicts it. */
  List<Belief> objections() {
    return List.copyOf(objections);
  }

  /** What witnesses say against what only its doer says. */
  List<Belief> denials() {
    return List.copyOf(denials);
  }

  /**
   * What witnesses say who looked for a thing where the other is that it is to be beside, or where
   * its doer says to have put it.
   */
  List<Belief> missed() {
    return List.copyOf(missed);
  }

  /** Witnesses that tell of it of their own accord whenever it changes. */
  SortedSet<String> tellers() {
    return tellers;
  }

  /** Devices that have said of it how it is, or have reported a deed that makes it so. */
  SortedSet<String> speakers() {
    return speakers;
  }

  /** When the oldest of what was observed too long ago was observed. */
  Optional<Instant> oldest() {
    return oldest;
  }

  /** Whether something is where nobody sees it. */
  boolean isOutOfSight() {
    return outOfSight;
  }

  /** Of alternatives the first that holds counts. */
  void collect(Formula formula) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(this::collect);
    } else if (formula instanceof Formula.Or or) {
      or.operands().stream().filter(this::holds).findFirst().ifPresent(this::collect);
    } else if (formula instanceof Formula.Exists exists) {
      witness(exists.variables(), exists.body()).ifPresent(this::collect);
    } else if (formula instanceof Formula.Forall forall) {
      instances(forall.variables(), forall.body()).forEach(this::collect);
    } else if (formula instanceof Formula.Comparison comparison) {
      Leaves.of(comparison, atom -> {}, number -> collect(number, comparison));
    } else if (formula instanceof Formula.Atom atom && atom.isGround()) {
      derivation(atom).ifPresentOrElse(this::collect, () -> collect(atom, atom));
    } else if (formula instanceof Formula.Not not
        && not.operand() instanceof Formula.Atom atom
        && atom.isGround()) {
      derivation(atom)
          .map(derived -> Assured.of(new Formula.Not(derived), vocabulary))
          .ifPresentOrElse(this::collect, () -> collect(atom, not));
    }
  }

  /** Whether the thing is in something that has its place and no area, into which one could see. */
  private boolean isClosed(Formula.Atom atom) {
    Individual place =
        atom.arguments().get(atom.arguments().size() - 1) instanceof Term.Name name
            ? home.individuals().get(name.text())
            : null;
    return place != null
        && !place.properties().containsKey("outline")
        && Stream.of("pose", POSITION).anyMatch(place.properties()::containsKey);
  }

  private void collect(Expression.Fluent number, Formula comparison) {
    List<Belief> claims = snapshot.claims(number);
    if (claims.isEmpty()) {
      collectThings(number.arguments(), List.of(), number.name(), comparison);
    } else if (!isSure(snapshot.belief(number), number.name())
        && !testimony.isWitnessed(claims, number.name(), comparison)) {
      numbers.add(number);
      note(snapshot.belief(number), claims, number.name(), comparison);
    }
  }

  /**
   * @param condition the atom, or that it does not hold
   */
  private void collect(Formula.Atom atom, Formula condition) {
    String name = atom.predicate();
    List<Belief> claims = snapshot.claims(atom);
    Optional<PredicateDeclaration> seeable =
        vocabulary.predicate(name).filter(declared -> declared.observedWhen().isPresent());
    if (seeable.isPresent() && testimony.isWitnessed(claims, name, condition)) {
      collectObjections(atom, condition);
    } else if (seeable.isPresent()) {
      // Where a thing is, the thing tells when it is seen; nobody can see the place.
      int seen = seeable.get().functional() ? 1 : atom.arguments().size();
      outOfSight |= seeable.get().functional() && condition == atom && isClosed(atom);
      collectThings(atom.arguments().subList(0, seen), claims, name, condition);
      note(snapshot.belief(atom), claims, name, condition);
      collectObjections(atom, condition);
    } else if (claims.isEmpty()) {
      if (condition instanceof Formula.Not && testimony.isChangedBySomebody(name)) {
        // That nobody has said so is no sight of it: who was lost at it may have done it.
        facts.add(atom);
      }
      collectThings(atom.arguments(), claims, name, condition);
    } else if (!isSure(snapshot.belief(atom), name)
        && !testimony.isWitnessed(claims, name, condition)) {
      facts.add(atom);
      note(snapshot.belief(atom), claims, name, condition);
    }
  }

  /** Those of which something is said, and no witness has seen of late that it is so. */
  private void collectThings(
      List<Term> arguments, List<Belief> claims, String name, Formula condition) {
    for (Term argument : arguments) {
      if (argument instanceof Term.Name thing) {
        List<Belief> places = testimony.ofPlace(thing);
        if (!(places.isEmpty() && claims.stream().allMatch(said -> isSure(said, name)))
            && !testimony.isSeen(places, condition)) {
          things.add(thing.text());
          note(position(thing), places, POSITION, condition);
          noteMissed(thing, arguments, claims);
          claims.stream().filter(OnlyExpected::isExpected).forEach(said -> noteMissed(thing, said));
        }
      }
    }
  }

  /** What its doer says of it and of another holds, as far as is known, where the other is. */
  private void noteMissed(Term.Name thing, List<Term> arguments, List<Belief> claims) {
    for (PredicateDeclaration declared : vocabulary.predicates().values()) {
      if (declared.functional() && declared.observedWhen().isPresent()) {
        String name = declared.name();
        for (Term other : arguments) {
          snapshot
              .value(name, List.of(other))
              .filter(place -> !other.equals(thing))
              .map(place -> new Formula.Atom(name, List.of(thing, place)))
              .ifPresent(
                  there ->
                      claims.stream()
                          .filter(OnlyExpected::isExpected)
                          .map(said -> deniedSince(there, said.since()))
                          .forEach(missed::addAll));
        }
      }
    }
  }

  /** Who did it has said as well where the thing is, and others have looked there since. */
  private void noteMissed(Term.Name thing, Belief said) {
    for (PredicateDeclaration declared : vocabulary.predicates().values()) {
      if (declared.functional() && declared.observedWhen().isPresent()) {
        snapshot.claims(new Formula.Atom(declared.name(), List.of(thing, thing))).stream()
            .filter(place -> isExpected(place) && place.source().equals(said.source()))
            .filter(place -> place.since().equals(said.since()))
            .map(place -> SlParser.formula(place.fact(), vocabulary::isFluent))
            .filter(Formula.Atom.class::isInstance)
            .map(Formula.Atom.class::cast)
            .map(there -> deniedSince(there, said.since()))
            .forEach(missed::addAll);
      }
    }
  }

  private List<Belief> deniedSince(Formula.Atom atom, Instant since) {
    return testimony.denials(snapshot.claims(atom), atom.predicate(), atom, since);
  }

  private boolean isSure(Optional<Belief> believed, String name) {
    return believed.filter(said -> !isSure(said, name)).isEmpty();
  }

  private boolean isSure(Belief believed, String name) {
    return testimony.isWitness(believed, name) && !testimony.isOld(believed, name);
  }

  /** Who says so without being a witness, who says otherwise, and how long ago it was seen. */
  private void note(
      Optional<Belief> believed, List<Belief> claims, String name, Formula condition) {
    believed
        .filter(said -> !testimony.isWitness(said, name))
        .ifPresent(said -> reporters.add(said.source().agent()));
    believed
        .filter(said -> testimony.isOld(said, name))
        .map(Belief::since)
        .filter(then -> oldest.filter(o -> !o.isAfter(then)).isEmpty())
        .ifPresent(then -> oldest = Optional.of(then));
    believed
        .map(said -> testimony.denials(claims, name, condition, said.since()))
        .ifPresent(denials::addAll);
    claims.stream()
        .filter(said -> said.source().kind() == Source.Kind.STATED)
        .filter(said -> testimony.isWitness(said, name))
        .forEach(said -> tellers.add(said.source().agent()));
    claims.stream()
        .filter(said -> said.source().kind() == Source.Kind.STATED || isExpected(said))
        .map(said -> said.source().agent())
        .filter(home.devices()::containsKey)
        .forEach(device -> speakers.add(device));
  }

  /**
   * A surer source counts, also when another says otherwise since: but then it is time to look
   * again. Of equally sure sources the later one is believed, and nothing is said since.
   */
  private void collectObjections(Formula.Atom atom, Formula condition) {
    if (!atom.equals(condition)) {
      return;
    }
    for (Dispute dispute : snapshot.disputes()) {
      for (Dispute.Loser loser : dispute.losers()) {
        Belief said = loser.belief();
        boolean since =
            dispute.believed().filter(b -> b.since().isBefore(said.since())).isPresent();
        if (since
            && !isExpected(said)
            && !isExpected(dispute.believed().get())
            && new AsClaimed(snapshot, home, said).contradicts(atom)) {
          objections.add(said);
          subject(said)
              .filter(thing -> atom.arguments().contains(thing))
              .ifPresent(thing -> things.add(thing.text()));
        }
      }
    }
  }

  private Optional<Term.Name> subject(Belief belief) {
    List<Term.Name> subjects = new ArrayList<>();
    Leaves.of(
        SlParser.formula(belief.fact(), vocabulary::isFluent),
        atom -> {
          if (atom.arguments().get(0) instanceof Term.Name name) {
            subjects.add(name);
          }
        },
        fluent -> {});
    return subjects.stream().findFirst();
  }

  private boolean holds(Formula formula) {
    return new Evaluation(snapshot).truth(formula, Map.of()) == Truth.TRUE;
  }

  /** The body with values for which it holds. */
  private Optional<Formula> witness(List<TypedVariable> variables, Formula body) {
    if (variables.isEmpty()) {
      return Optional.of(body).filter(this::holds);
    }
    TypedVariable first = variables.get(0);
    List<TypedVariable> others = variables.subList(1, variables.size());
    return first.className().stream()
        .flatMap(name -> snapshot.individuals(name).stream())
        .map(value -> new Substitution(Map.of(first.name(), value)).apply(body))
        .flatMap(bound -> witness(others, bound).stream())
        .findFirst();
  }

  /** The body with each choice of values. */
  private List<Formula> instances(List<TypedVariable> variables, Formula body) {
    if (variables.isEmpty()) {
      return List.of(body);
    }
    TypedVariable first = variables.get(0);
    List<TypedVariable> others = variables.subList(1, variables.size());
    return snapshot.individuals(first.className().orElse("")).stream()
        .map(value -> new Substitution(Map.of(first.name(), value)).apply(body))
        .flatMap(bound -> instances(others, bound).stream())
        .toList();
  }

  /** What a derived atom says in the words that it is derived from. */
  private Optional<Formula> derivation(Formula.Atom atom) {
    return vocabulary
        .predicate(atom.predicate())
        .filter(declared -> declared.parameters().size() == atom.arguments().size())
        .flatMap(
            declared -> {
              Map<String, Term> bindings = new TreeMap<>();
              for (int i = 0; i < atom.arguments().size(); i++) {
                bindings.put(declared.parameters().get(i).name(), atom.arguments().get(i));
              }
              return declared.derivedWhen().map(new Substitution(bindings)::apply);
            });
  }

  private static boolean isExpected(Belief belief) {
    return belief.source().kind() == Source.Kind.EXPECTED;
  }

  private Optional<Belief> position(Term.Name thing) {
    return snapshot
        .value(POSITION, List.of(thing))
        .flatMap(value -> snapshot.belief(new Formula.Atom(POSITION, List.of(thing, value))));
  }
}
