package org.maestro.coordination;

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
import org.maestro.knowledge.AsClaimed;
import org.maestro.knowledge.Belief;
import org.maestro.knowledge.Dispute;
import org.maestro.knowledge.Snapshot;
import org.maestro.knowledge.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
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
 * What a goal that holds rests on without anybody having observed it of late, or though somebody
 * has said otherwise since: things whose place is only expected, disputed or was seen too long ago,
 * and observable numbers that are only reckoned or were measured too long ago. Sources of numbers
 * differ always a little; of these the surer counts.
 */
final class OnlyExpected {
  private static final String POSITION = "position";

  private final Snapshot snapshot;
  private final Home home;
  private final Vocabulary vocabulary;
  private final SortedSet<String> things = new TreeSet<>();
  private final List<Expression.Fluent> numbers = new ArrayList<>();
  private final SortedSet<String> reporters = new TreeSet<>();
  private final Set<Belief> objections = new LinkedHashSet<>();
  private final Instant notBefore;
  private Optional<Instant> oldest = Optional.empty();

  /**
   * @param notBefore what was observed earlier has to be observed again: anybody may have changed
   *     it since
   */
  OnlyExpected(Snapshot snapshot, Home home, Instant notBefore) {
    this.snapshot = snapshot;
    this.home = home;
    this.notBefore = notBefore;
    this.vocabulary = home.vocabulary();
  }

  SortedSet<String> things() {
    return things;
  }

  List<Expression.Fluent> numbers() {
    return numbers;
  }

  /** Whose deeds let it be expected. */
  SortedSet<String> reporters() {
    return reporters;
  }

  /** What others have said since what is believed, and what contradicts it. */
  List<Belief> objections() {
    return List.copyOf(objections);
  }

  /** When the oldest of what was observed too long ago was observed. */
  Optional<Instant> oldest() {
    return oldest;
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
      Leaves.of(comparison, atom -> {}, this::collect);
    } else if (formula instanceof Formula.Atom atom && atom.isGround()) {
      Optional<Formula> derivation = derivation(atom);
      derivation.ifPresentOrElse(this::collect, () -> collectThings(atom));
    } else if (formula instanceof Formula.Not not
        && not.operand() instanceof Formula.Atom atom
        && atom.isGround()) {
      collectSeenLongAgo(atom);
    }
  }

  private void collect(Expression.Fluent number) {
    Optional<Belief> belief = snapshot.belief(number);
    Optional<Belief> expected = expected(belief);
    boolean observable =
        vocabulary.predicate(number.name()).filter(PredicateDeclaration::observable).isPresent();
    boolean measured =
        expected.isEmpty() && belief.filter(said -> !isMeasured(number, said)).isEmpty();
    if (observable && !numbers.contains(number) && (!measured || isOld(belief))) {
      expected.ifPresent(reckoned -> reporters.add(reckoned.source().agent()));
      numbers.add(number);
    }
  }

  /** Who only declined a step for its sake is no witness of a number. */
  private boolean isMeasured(Expression.Fluent number, Belief belief) {
    Device device = home.devices().get(belief.source().agent());
    return belief.source().kind() != Source.Kind.OBSERVED
        || device == null
        || device.features().stream()
            .anyMatch(feature -> Sensing.names(feature.effect()).contains(number.name()));
  }

  private void collectThings(Formula.Atom atom) {
    Optional<PredicateDeclaration> seeable =
        vocabulary
            .predicate(atom.predicate())
            .filter(declared -> declared.observedWhen().isPresent());
    Optional<Belief> expected = expected(snapshot.belief(atom));
    if (seeable.isPresent() && expected.isPresent()) {
      reporters.add(expected.get().source().agent());
      // Where a thing is, the thing tells when it is seen; nobody can see the place.
      int seen = seeable.get().functional() ? 1 : atom.arguments().size();
      for (Term argument : atom.arguments().subList(0, seen)) {
        if (argument instanceof Term.Name name && !isSeen(name)) {
          things.add(name.text());
        }
      }
    } else if (seeable.isPresent()) {
      collectObjections(atom);
      collectSeenLongAgo(atom);
    }
  }

  /** Where a thing is was seen as long ago as the thing. */
  private void collectSeenLongAgo(Formula.Atom atom) {
    Optional<PredicateDeclaration> seeable =
        vocabulary
            .predicate(atom.predicate())
            .filter(declared -> declared.observedWhen().isPresent());
    if (seeable.isEmpty()) {
      return;
    }
    int seen = seeable.get().functional() ? 1 : atom.arguments().size();
    for (Term argument : atom.arguments().subList(0, seen)) {
      if (argument instanceof Term.Name name
          && isOld(position(name).or(() -> snapshot.belief(atom)))) {
        things.add(name.text());
      }
    }
  }

  private boolean isOld(Optional<Belief> belief) {
    Optional<Instant> since =
        belief
            .filter(b -> b.source().kind() == Source.Kind.OBSERVED)
            .map(Belief::since)
            .filter(notBefore::isAfter);
    since
        .filter(then -> oldest.filter(o -> !o.isAfter(then)).isEmpty())
        .ifPresent(then -> oldest = Optional.of(then));
    return since.isPresent();
  }

  /**
   * A surer source counts, also when another says otherwise since: but then it is time to look
   * again. Of equally sure sources the later one is believed, and nothing is said since.
   */
  private void collectObjections(Formula.Atom atom) {
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

  private static Optional<Belief> expected(Optional<Belief> belief) {
    return belief.filter(OnlyExpected::isExpected);
  }

  private static boolean isExpected(Belief belief) {
    return belief.source().kind() == Source.Kind.EXPECTED;
  }

  private boolean isSeen(Term.Name thing) {
    Optional<Belief> position = position(thing).filter(belief -> !isExpected(belief));
    return position.isPresent() && !isOld(position);
  }

  private Optional<Belief> position(Term.Name thing) {
    return snapshot
        .value(POSITION, List.of(thing))
        .flatMap(value -> snapshot.belief(new Formula.Atom(POSITION, List.of(thing, value))));
  }
}
