package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/**
 * The words whose values follow from where things are, such as how far they are from each other.
 * They are known as soon as the things have been seen, and no feature says what it does to them.
 * Immutable.
 */
public final class ReckonedFromPlaces {
  private static final String POSITION = "position";

  private final Vocabulary vocabulary;

  public ReckonedFromPlaces(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  /** Whether the word is computed, of whatever stands where it stands too. */
  boolean isReckoned(String name) {
    return vocabulary.predicate(name).flatMap(PredicateDeclaration::computedBy).isPresent();
  }

  /** Whether the formula speaks of what changes when things are moved. */
  public boolean isIn(Formula formula, Facts facts) {
    boolean[] any = new boolean[1];
    Leaves.of(
        formula,
        atom -> any[0] |= isReckoned(atom.predicate()) && isOfThings(atom.arguments(), facts),
        fluent -> any[0] |= isReckoned(fluent.name()) && isOfThings(fluent.arguments(), facts));
    return any[0];
  }

  /** Whether any of them is something that can be elsewhere, or may stand for such. */
  boolean isOfThings(List<Term> arguments, Facts facts) {
    return arguments.stream()
        .anyMatch(
            argument ->
                argument instanceof Term.Variable
                    || classOfThings()
                        .filter(name -> facts.individuals(name).contains(argument))
                        .isPresent());
  }

  /** What stands where it stands need not be seen. */
  Formula seenIfThing(Term argument) {
    List<Formula> parts = new ArrayList<>();
    parts.add(Confirmation.seen(argument));
    classOfThings()
        .map(name -> new Formula.Not(new Formula.Atom(name, List.of(argument))))
        .ifPresent(parts::add);
    return new Formula.Or(parts);
  }

  private Optional<String> classOfThings() {
    return vocabulary
        .predicate(POSITION)
        .flatMap(position -> position.parameters().get(0).className());
  }
}
