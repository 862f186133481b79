package org.maestro.coordination.undoing;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Former;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.facts.ProgressedState;
import org.maestro.coordination.facts.Settings;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What was so before the steps of one goal changed it, and how many of them are under way. */
final class FormerOfGoal {
  private static final String LOCATION = "Location";
  private static final long BYTES = 256;

  private final Home home;

  /** What was so, by what was changed; empty where nobody knew. */
  private final Map<Formula, Optional<Formula>> before = new LinkedHashMap<>();

  /** Where those are who did it, each with what tells so. */
  private final Map<Formula, Term> ownPlaces = new LinkedHashMap<>();

  private final List<Runnable> awaiting = new ArrayList<>();
  private int underWay;

  FormerOfGoal(Home home) {
    this.home = home;
  }

  /**
   * @param known whether these are the facts before the step
   */
  void begun(Step step, Facts facts, boolean known) {
    underWay++;
    Set<Expression.Fluent> assigned = Settings.assigned(step);
    for (Change change : ProgressedState.changes(facts, step)) {
      if (change instanceof Change.OfTruth truth && isOfTheHome(truth.atom())) {
        note(truth.atom(), known ? former(truth.atom(), facts) : Optional.empty());
        ownPlace(truth.atom(), step.member());
      } else if (change instanceof Change.OfNumber number && assigned.contains(number.fluent())) {
        note(
            equal(number.fluent(), new Term.Variable("value")),
            known ? former(number.fluent(), facts) : Optional.empty());
      }
    }
  }

  /** Plans have atoms of their own, such as that something was measured. */
  private boolean isOfTheHome(Formula.Atom atom) {
    return home.vocabulary().predicates().containsKey(atom.predicate());
  }

  /** What comes first is what was so. */
  private void note(Formula changed, Optional<Formula> former) {
    before.putIfAbsent(changed, former);
  }

  private static Formula equal(Expression.Fluent fluent, Term value) {
    return new Formula.Comparison(Formula.Relation.EQUAL, fluent, new Expression.OfTerm(value));
  }

  private static Optional<Formula> former(Expression.Fluent fluent, Facts facts) {
    return facts.number(fluent).isPresent()
        ? Optional.of(equal(fluent, new Term.Number(facts.number(fluent).getAsDouble())))
        : Optional.empty();
  }

  private Optional<Formula> former(Formula.Atom atom, Facts facts) {
    Truth truth = facts.truth(atom);
    if (truth == Truth.TRUE) {
      return Optional.of(atom);
    }
    Optional<Formula> other =
        isFunctional(atom)
            ? facts.individuals("").stream()
                .<Formula>map(value -> with(atom, value))
                .filter(one -> facts.truth((Formula.Atom) one) == Truth.TRUE)
                .findFirst()
            : Optional.empty();
    return other.or(
        () -> truth == Truth.FALSE ? Optional.of(new Formula.Not(atom)) : Optional.empty());
  }

  private boolean isFunctional(Formula.Atom atom) {
    return home.vocabulary()
        .predicate(atom.predicate())
        .filter(PredicateDeclaration::functional)
        .isPresent();
  }

  private static Formula.Atom with(Formula.Atom atom, Term value) {
    List<Term> arguments = new ArrayList<>(atom.arguments());
    arguments.set(arguments.size() - 1, value);
    return new Formula.Atom(atom.predicate(), arguments);
  }

  private void ownPlace(Formula.Atom atom, String member) {
    List<Term> arguments = atom.arguments();
    if (arguments.size() > 1
        && arguments.get(0).equals(new Term.Name(member))
        && isPlace(arguments.get(arguments.size() - 1))) {
      ownPlaces.put(atom, new Term.Name(member));
    }
  }

  private boolean isPlace(Term term) {
    Individual individual =
        term instanceof Term.Name name ? home.individuals().get(name.text()) : null;
    return individual != null && individual.classes().contains(LOCATION);
  }

  /** One that was begun is over; told are those who have waited for the last. */
  List<Runnable> ended() {
    underWay--;
    List<Runnable> due = underWay > 0 ? List.of() : List.copyOf(awaiting);
    if (underWay <= 0) {
      awaiting.clear();
    }
    return due;
  }

  boolean isUnderWay() {
    return underWay > 0;
  }

  void await(Runnable then) {
    awaiting.add(then);
  }

  /**
   * @param others what is wanted now: of what these speak nothing is to be as it was
   */
  Former before(Formula goal, List<Formula> others) {
    Set<Formula> wishes = new LinkedHashSet<>();
    List<String> unknown = new ArrayList<>();
    Set<Term> spoken = names(goal);
    before.forEach(
        (changed, former) -> {
          if (!ownPlaces.containsKey(changed) || spoken.contains(ownPlaces.get(changed))) {
            former.ifPresentOrElse(wishes::add, () -> unknown.add(text(changed)));
          }
        });
    wishes.removeIf(wish -> isImplied(wish, wishes));
    FactFilter wanted = filter(others);
    wishes.removeIf(wish -> wanted.isConcernedBy(filter(List.of(wish))));
    return new Former(List.copyOf(wishes), unknown);
  }

  private FactFilter filter(List<Formula> formulas) {
    FactFilter filter = new FactFilter(home.vocabulary());
    formulas.forEach(filter::addRead);
    return filter;
  }

  private static Set<Term> names(Formula goal) {
    Set<Term> names = new HashSet<>();
    Leaves.of(goal, atom -> names.addAll(atom.arguments()), of -> names.addAll(of.arguments()));
    return names;
  }

  private static String text(Formula changed) {
    return changed instanceof Formula.Comparison number
        ? SlPrinter.print(number.left())
        : SlPrinter.print(changed);
  }

  /** What has another value has not this one. */
  private boolean isImplied(Formula wish, Set<Formula> wishes) {
    return wish instanceof Formula.Not not
        && not.operand() instanceof Formula.Atom atom
        && isFunctional(atom)
        && wishes.stream()
            .anyMatch(
                one ->
                    one instanceof Formula.Atom other
                        && other.predicate().equals(atom.predicate())
                        && other
                            .arguments()
                            .subList(0, other.arguments().size() - 1)
                            .equals(atom.arguments().subList(0, atom.arguments().size() - 1)));
  }

  long bytes() {
    return BYTES * (1 + before.size());
  }
}
