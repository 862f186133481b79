package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The facts of a task; each is asked once, as derived and geometric ones take their time. Where the
 * facts tell on what an answer rests, only what may be otherwise is asked again of others.
 */
public final class StaticFacts {
  private Facts facts;
  private Facts asked;
  private boolean tracing;
  private final Map<Formula.Atom, Truth> truths = new HashMap<>();
  private final Map<Expression.Fluent, Double> numbers = new HashMap<>();
  private final Map<Whom, Optional<Set<Term>>> candidates = new HashMap<>();
  private final Map<Which, Optional<Set<Term>>> aboveZero = new HashMap<>();
  private final Map<String, List<Term>> individuals = new HashMap<>();

  /** The questions whose answers rest on something. */
  private final Map<Object, Set<Object>> restingOn = new HashMap<>();

  private final Set<Object> told = new LinkedHashSet<>();

  /** The question for whom an atom may hold. */
  private record Whom(Formula.Atom atom, String variable) {}

  /** The question with which individuals a number may be more than zero. */
  private record Which(Expression.Fluent fluent, String variable) {}

  /**
   * The differences of other facts from these, in what was asked.
   *
   * @param changed atoms and fluents that steps may change
   * @param ofWhatStays whether others are otherwise too
   */
  public record Difference(Set<Object> changed, boolean ofWhatStays) {}

  public StaticFacts(Facts facts) {
    take(facts);
  }

  private StaticFacts(Facts facts, Facts asked) {
    this.facts = facts;
    this.asked = asked;
  }

  /** Those for one task: on what answers rest is not kept, which takes time and memory. */
  public static StaticFacts forOnce(Facts facts) {
    return new StaticFacts(facts, facts);
  }

  private void take(Facts next) {
    facts = next;
    Optional<Facts> traced = next.tracing(told::add);
    tracing = traced.isPresent();
    asked = traced.orElse(next);
  }

  /** Whether these facts can tell what may be otherwise there. */
  public boolean isNear(Facts next) {
    return next == facts || tracing && next.changedSince(facts).isPresent();
  }

  /** How many answers are kept. */
  public int size() {
    return truths.size() + numbers.size();
  }

  /**
   * Takes other facts.
   *
   * @return what of all that was asked is otherwise there; empty when there are other individuals,
   *     and then these facts were not taken
   */
  public Optional<Difference> renew(Facts next, Signature signature) {
    if (next == facts) {
      return Optional.of(new Difference(Set.of(), false));
    }
    Optional<Set<Object>> otherwise = tracing ? next.changedSince(facts) : Optional.empty();
    if (otherwise.isEmpty() && !hasTheSameIndividuals(next)) {
      return Optional.empty();
    }
    take(next);
    return Optional.of(askedAgain(otherwise.map(this::questions).orElseGet(this::all), signature));
  }

  private boolean hasTheSameIndividuals(Facts next) {
    return individuals.entrySet().stream()
        .allMatch(known -> known.getValue().equals(List.copyOf(next.individuals(known.getKey()))));
  }

  private Set<Object> questions(Set<Object> otherwise) {
    Set<Object> questions = new LinkedHashSet<>();
    otherwise.forEach(ground -> questions.addAll(restingOn.getOrDefault(ground, Set.of())));
    return questions;
  }

  private Set<Object> all() {
    Set<Object> questions = new LinkedHashSet<>(truths.keySet());
    questions.addAll(numbers.keySet());
    questions.addAll(candidates.keySet());
    questions.addAll(aboveZero.keySet());
    return questions;
  }

  private Difference askedAgain(Set<Object> questions, Signature signature) {
    Set<Object> changed = new LinkedHashSet<>();
    boolean ofWhatStays = false;
    for (Object question : questions) {
      String name;
      boolean same;
      if (question instanceof Formula.Atom atom) {
        name = atom.predicate();
        same = truths.put(atom, askedTruth(atom)) == truths.get(atom);
      } else if (question instanceof Whom whom) {
        name = whom.atom().predicate();
        Optional<Set<Term>> before = candidates.put(whom, askedCandidates(whom));
        same = candidates.get(whom).equals(before);
      } else if (question instanceof Which which) {
        name = which.fluent().name();
        Optional<Set<Term>> before = aboveZero.put(which, askedAboveZero(which));
        same = aboveZero.get(which).equals(before);
      } else {
        Expression.Fluent fluent = (Expression.Fluent) question;
        name = fluent.name();
        same = Double.compare(numbers.put(fluent, askedNumber(fluent)), numbers.get(fluent)) == 0;
      }
      if (!same && signature.isDynamic(name)) {
        changed.add(question);
      } else {
        ofWhatStays |= !same;
      }
    }
    return new Difference(changed, ofWhatStays);
  }

  public Truth truth(Formula.Atom atom) {
    Truth known = truths.get(atom);
    if (known == null) {
      known = askedTruth(atom);
      truths.put(atom, known);
    }
    return known;
  }

  private Truth askedTruth(Formula.Atom atom) {
    told.clear();
    Truth truth = asked.truth(atom);
    told.forEach(ground -> rest(ground, atom));
    return truth;
  }

  private void rest(Object ground, Object question) {
    restingOn.computeIfAbsent(ground, absent -> new LinkedHashSet<>()).add(question);
  }

  /** As {@link Facts#candidates}. */
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    Whom whom = new Whom(atom, variable);
    Optional<Set<Term>> known = candidates.get(whom);
    if (known == null) {
      known = askedCandidates(whom);
      candidates.put(whom, known);
    }
    return known;
  }

  private Optional<Set<Term>> askedCandidates(Whom whom) {
    told.clear();
    Optional<Set<Term>> found = asked.candidates(whom.atom(), whom.variable());
    told.forEach(ground -> rest(ground, whom));
    return found;
  }

  /** As {@link Facts#aboveZero}. */
  public Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String variable) {
    Which which = new Which(fluent, variable);
    Optional<Set<Term>> known = aboveZero.get(which);
    if (known == null) {
      known = askedAboveZero(which);
      aboveZero.put(which, known);
    }
    return known;
  }

  private Optional<Set<Term>> askedAboveZero(Which which) {
    told.clear();
    Optional<Set<Term>> found = asked.aboveZero(which.fluent(), which.variable());
    told.forEach(ground -> rest(ground, which));
    return found;
  }

  /** The number, or {@link Quantity#UNKNOWN}. */
  public double number(Expression.Fluent fluent) {
    Double known = numbers.get(fluent);
    if (known == null) {
      known = askedNumber(fluent);
      numbers.put(fluent, known);
    }
    return known;
  }

  private double askedNumber(Expression.Fluent fluent) {
    told.clear();
    double number = asked.number(fluent).orElse(Quantity.UNKNOWN);
    told.forEach(ground -> rest(ground, fluent));
    return Double.isFinite(number) ? Quantity.rounded(number) : Quantity.UNKNOWN;
  }

  public double chanceStill(Formula.Atom atom) {
    return facts.chanceStill(atom);
  }

  /** In the stable order of the facts. */
  public List<Term> individuals(String className) {
    List<Term> known = individuals.get(className);
    if (known == null) {
      known = List.copyOf(new ArrayList<Term>(facts.individuals(className)));
      individuals.put(className, known);
    }
    return known;
  }
}
