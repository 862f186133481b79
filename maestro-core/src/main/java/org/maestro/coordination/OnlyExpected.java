package org.maestro.coordination;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.knowledge.Belief;
import org.maestro.knowledge.Snapshot;
import org.maestro.knowledge.Source;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * What a goal that holds rests on without anybody having observed it: things whose place is only
 * expected, and observable numbers that are only reckoned.
 */
final class OnlyExpected {
  private static final String POSITION = "position";

  private final Snapshot snapshot;
  private final Vocabulary vocabulary;
  private final SortedSet<String> things = new TreeSet<>();
  private final List<Expression.Fluent> numbers = new ArrayList<>();

  OnlyExpected(Snapshot snapshot, Vocabulary vocabulary) {
    this.snapshot = snapshot;
    this.vocabulary = vocabulary;
  }

  SortedSet<String> things() {
    return things;
  }

  List<Expression.Fluent> numbers() {
    return numbers;
  }

  /** Of alternatives the first that holds counts. */
  void collect(Formula formula) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(this::collect);
    } else if (formula instanceof Formula.Or or) {
      or.operands().stream().filter(this::holds).findFirst().ifPresent(this::collect);
    } else if (formula instanceof Formula.Exists exists) {
      witness(exists.variables(), exists.body()).ifPresent(this::collect);
    } else if (formula instanceof Formula.Comparison comparison) {
      Leaves.of(comparison, atom -> {}, this::collect);
    } else if (formula instanceof Formula.Atom atom && atom.isGround()) {
      Optional<Formula> derivation = derivation(atom);
      derivation.ifPresentOrElse(this::collect, () -> collectThings(atom));
    }
  }

  private void collect(Expression.Fluent number) {
    boolean observable =
        vocabulary.predicate(number.name()).filter(PredicateDeclaration::observable).isPresent();
    if (observable
        && !numbers.contains(number)
        && snapshot.belief(number).filter(OnlyExpected::isExpected).isPresent()) {
      numbers.add(number);
    }
  }

  private void collectThings(Formula.Atom atom) {
    Optional<PredicateDeclaration> seeable =
        vocabulary
            .predicate(atom.predicate())
            .filter(declared -> declared.observedWhen().isPresent());
    if (seeable.isPresent() && snapshot.belief(atom).filter(OnlyExpected::isExpected).isPresent()) {
      // Where a thing is, the thing tells when it is seen; nobody can see the place.
      int seen = seeable.get().functional() ? 1 : atom.arguments().size();
      for (Term argument : atom.arguments().subList(0, seen)) {
        if (argument instanceof Term.Name name && !isSeen(name)) {
          things.add(name.text());
        }
      }
    }
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

  private boolean isSeen(Term.Name thing) {
    return snapshot
        .value(POSITION, List.of(thing))
        .flatMap(value -> snapshot.belief(new Formula.Atom(POSITION, List.of(thing, value))))
        .filter(belief -> !isExpected(belief))
        .isPresent();
  }
}
