package org.maestro.knowledge.belief;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The predicates as the home's vocabulary declares them: how each is to be kept. Immutable. */
public final class Declarations {

  /** Where a thing is, as a text; the one predicate that is known without a vocabulary. */
  public static final String POSITION = "position";

  /** Where the home says that a thing is fixed. */
  static final String POSE = "pose";

  private static final int PAIR = 2;

  private final Home home;
  private final Map<Subject, Optional<Duration>> validities = new ConcurrentHashMap<>();

  /** The predicate and the first argument on which a validity depends. */
  private record Subject(String predicate, Optional<Term> first) {}

  Declarations(Home home) {
    this.home = home;
  }

  Optional<PredicateDeclaration> declared(String predicate) {
    return home.vocabulary().predicate(predicate);
  }

  public boolean isFunctional(String predicate) {
    return predicate.equals(POSITION)
        || declared(predicate).filter(d -> d.functional() && !d.fluent()).isPresent();
  }

  public boolean isObservable(String predicate) {
    return predicate.equals(POSITION)
        || declared(predicate).filter(PredicateDeclaration::observable).isPresent();
  }

  public boolean isFluent(String predicate) {
    return declared(predicate).filter(PredicateDeclaration::fluent).isPresent();
  }

  /** No value of the fluent is below it. */
  public double least(String fluent) {
    return declared(fluent)
        .map(PredicateDeclaration::least)
        .orElseGet(OptionalDouble::empty)
        .orElse(Double.NEGATIVE_INFINITY);
  }

  /** Symmetric atoms are kept once, with their arguments in the order of their texts. */
  public Formula.Atom canonical(Formula.Atom atom) {
    if (atom.arguments().size() != PAIR
        || declared(atom.predicate()).filter(PredicateDeclaration::symmetric).isEmpty()) {
      return atom;
    }
    List<Term> ordered = new ArrayList<>(atom.arguments());
    ordered.sort(Comparator.comparing(Declarations::text));
    return new Formula.Atom(atom.predicate(), ordered);
  }

  private static String text(Term term) {
    return term instanceof Term.Name name ? name.text() : SlPrinter.print(term);
  }

  /** The variable that a canonical atom gives a value to. */
  StateVariable variable(Formula.Atom atom) {
    int size = atom.arguments().size();
    return isFunctional(atom.predicate()) && size > 0
        ? new StateVariable(atom.predicate(), atom.arguments().subList(0, size - 1))
        : new StateVariable(atom.predicate(), atom.arguments());
  }

  /** The variable that an atom speaks of; a fluent is written as an atom. */
  public StateVariable spokenOf(Formula.Atom atom) {
    return isFluent(atom.predicate())
        ? new StateVariable(atom.predicate(), atom.arguments())
        : variable(canonical(atom));
  }

  public StateVariable spokenOf(Fact fact) {
    return spokenOf(FactReader.atom(fact));
  }

  /** The value that a canonical atom gives to its variable when it holds. */
  public Term valueOf(Formula.Atom atom) {
    int size = atom.arguments().size();
    return isFunctional(atom.predicate()) && size > 0
        ? atom.arguments().get(size - 1)
        : new Term.Truth(true);
  }

  /**
   * The last instant at which the variable's value counts. The shortest age wins where several
   * classes of the first argument have one of their own. What a member says of itself, and of what
   * it carries, stays: it would tell a change, and its loss is noticed.
   */
  Instant expires(StateVariable variable, Term value, Source source, Instant since) {
    Term speaker = new Term.Name(source.agent());
    boolean ofItself =
        source.kind() == Source.Kind.STATED && (variable.isAbout(speaker) || value.equals(speaker));
    if (ofItself) {
      return Instant.MAX;
    }
    return validities
        .computeIfAbsent(
            new Subject(variable.predicate(), variable.arguments().stream().findFirst()),
            subject -> validFor(variable))
        .map(since::plus)
        .orElse(Instant.MAX);
  }

  private Optional<Duration> validFor(StateVariable variable) {
    Optional<Term> subject = variable.arguments().stream().findFirst();
    Optional<Duration> own = declared(variable.predicate()).flatMap(p -> validFor(p, subject));
    return variable.predicate().equals(POSITION)
        ? Stream.concat(own.stream(), placesValidFor(subject)).min(Comparator.naturalOrder())
        : own;
  }

  /** A position is no longer good than what it says of the thing's place. */
  private Stream<Duration> placesValidFor(Optional<Term> subject) {
    return home.vocabulary().predicates().values().stream()
        .filter(predicate -> predicate.functional() && predicate.observedWhen().isPresent())
        .flatMap(predicate -> validFor(predicate, subject).stream());
  }

  private Optional<Duration> validFor(PredicateDeclaration predicate, Optional<Term> subject) {
    Optional<Duration> ofClass =
        predicate.validForByClass().entrySet().stream()
            .filter(entry -> subject.filter(s -> isInstance(s, entry.getKey())).isPresent())
            .map(Map.Entry::getValue)
            .min(Comparator.naturalOrder());
    return ofClass.isPresent() ? ofClass : predicate.validFor();
  }

  private boolean isInstance(Term term, String className) {
    return individual(term).filter(i -> i.classes().contains(className)).isPresent();
  }

  private Optional<Individual> individual(Term term) {
    return term instanceof Term.Name name
        ? Optional.ofNullable(home.individuals().get(name.text()))
        : Optional.empty();
  }
}
