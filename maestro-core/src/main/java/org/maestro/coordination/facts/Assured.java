package org.maestro.coordination.facts;

import java.util.List;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;

/**
 * A goal such that what is not to be so has to be known not to be so. For a plan's conditions it is
 * enough that nobody knows of a hindrance; a goal that would be called reached because nobody has
 * looked would be a false claim.
 */
public final class Assured {
  private final Vocabulary vocabulary;

  private Assured(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
  }

  public static Formula of(Formula goal, Vocabulary vocabulary) {
    return new Assured(vocabulary).positive(goal);
  }

  private Formula positive(Formula formula) {
    if (formula instanceof Formula.And and) {
      return new Formula.And(and.operands().stream().map(this::positive).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(or.operands().stream().map(this::positive).toList());
    } else if (formula instanceof Formula.Not not) {
      return negative(not.operand());
    } else if (formula instanceof Formula.Imply imply) {
      return new Formula.Or(List.of(negative(imply.premise()), positive(imply.conclusion())));
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Exists(exists.variables(), positive(exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      return new Formula.Forall(forall.variables(), positive(forall.body()));
    } else if (formula instanceof Formula.Keep keep) {
      return new Formula.Keep(positive(keep.body()));
    }
    return formula;
  }

  private Formula negative(Formula formula) {
    if (formula instanceof Formula.And and) {
      return new Formula.Or(and.operands().stream().map(this::negative).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.And(or.operands().stream().map(this::negative).toList());
    } else if (formula instanceof Formula.Not not) {
      return positive(not.operand());
    } else if (formula instanceof Formula.Imply imply) {
      return new Formula.And(List.of(positive(imply.premise()), negative(imply.conclusion())));
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Forall(exists.variables(), negative(exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      return new Formula.Exists(forall.variables(), negative(forall.body()));
    } else if (formula instanceof Formula.Comparison comparison && isOfNumbers(comparison)) {
      return opposite(comparison);
    } else if (formula instanceof Formula.Atom atom && isObservable(atom)) {
      return new Formula.And(
          List.of(new Formula.Not(atom), new Formula.Not(new Formula.UnknownAtom(atom))));
    }
    return new Formula.Not(formula);
  }

  private boolean isObservable(Formula.Atom atom) {
    return vocabulary
        .predicate(atom.predicate())
        .filter(PredicateDeclaration::observable)
        .isPresent();
  }

  private static boolean isOfNumbers(Formula.Comparison comparison) {
    boolean[] fluent = new boolean[1];
    Leaves.of(comparison, atom -> {}, found -> fluent[0] = true);
    return fluent[0];
  }

  private static Formula opposite(Formula.Comparison comparison) {
    return switch (comparison.relation()) {
      case LESS -> with(comparison, Formula.Relation.AT_LEAST);
      case AT_MOST -> with(comparison, Formula.Relation.GREATER);
      case GREATER -> with(comparison, Formula.Relation.AT_MOST);
      case AT_LEAST -> with(comparison, Formula.Relation.LESS);
      case EQUAL ->
          new Formula.Or(
              List.of(
                  with(comparison, Formula.Relation.LESS),
                  with(comparison, Formula.Relation.GREATER)));
    };
  }

  private static Formula with(Formula.Comparison comparison, Formula.Relation relation) {
    return new Formula.Comparison(relation, comparison.left(), comparison.right());
  }
}
