package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Looks at what nobody can bring about: it may be so already. How two things stand to each other,
 * and how far from each other, is known as soon as both have been seen, so such a goal may be
 * reached by looks alone. Plans do not count on it as long as somebody can act.
 */
public final class EpistemicGoal {
  private static final String POSITION = "position";

  private final Vocabulary vocabulary;
  private final ReckonedFromPlaces reckoned;

  private EpistemicGoal(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
    this.reckoned = new ReckonedFromPlaces(vocabulary);
  }

  /** Whether the goal speaks of anything unknown that looks decide, and no look by itself tells. */
  public static boolean helps(Formula goal, Facts facts, Vocabulary vocabulary) {
    boolean[] any = new boolean[1];
    EpistemicGoal findingOut = new EpistemicGoal(vocabulary);
    Leaves.of(
        goal,
        atom ->
            any[0] |=
                (findingOut.isDecidedByLooks(atom)
                        || findingOut.isReckoned(atom.predicate(), atom.arguments(), facts))
                    && (!atom.isGround() || facts.truth(atom) == Truth.UNKNOWN),
        fluent ->
            any[0] |=
                findingOut.isReckoned(fluent.name(), fluent.arguments(), facts)
                    && facts.number(fluent).isEmpty());
    return any[0];
  }

  /** The goal, or to have seen all that decides it. */
  public static Formula goal(Formula goal, Vocabulary vocabulary) {
    return new EpistemicGoal(vocabulary).seen(goal);
  }

  /** The goal, and what looks tell; whoever can help with that is a candidate. */
  public static Formula relevant(Formula goal, Vocabulary vocabulary) {
    List<Formula> parts = new ArrayList<>();
    parts.add(goal);
    vocabulary.predicates().values().stream()
        .filter(declared -> declared.functional() && declared.observedWhen().isPresent())
        .forEach(
            declared ->
                parts.add(
                    new Formula.Atom(
                        declared.name(),
                        declared.parameters().stream()
                            .map(parameter -> (Term) new Term.Variable(parameter.name()))
                            .toList())));
    return new Formula.And(parts);
  }

  private boolean isDecidedByLooks(Formula.Atom atom) {
    return vocabulary
        .predicate(atom.predicate())
        .filter(declared -> !declared.functional() && declared.observedWhen().isPresent())
        .isPresent();
  }

  private boolean isReckoned(String name, List<Term> arguments, Facts facts) {
    return reckoned.isReckoned(name) && reckoned.isOfThings(arguments, facts);
  }

  private Formula seen(Formula formula) {
    if (formula instanceof Formula.And and) {
      return new Formula.And(and.operands().stream().map(this::seen).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(or.operands().stream().map(this::seen).toList());
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Exists(exists.variables(), seen(exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      return new Formula.Forall(forall.variables(), seen(forall.body()));
    } else if (formula instanceof Formula.Comparison
        || formula instanceof Formula.Atom atom && reckoned.isReckoned(atom.predicate())) {
      return orReckoned(formula);
    } else if (formula instanceof Formula.Atom atom && isDecidedByLooks(atom)) {
      return orSeen(formula, atom);
    } else if (formula instanceof Formula.Not not
        && not.operand() instanceof Formula.UnknownAtom unknown
        && isDecidedByLooks(unknown.atom())) {
      return orSeen(formula, unknown.atom());
    }
    return formula;
  }

  private static Formula orSeen(Formula formula, Formula.Atom atom) {
    List<Formula> parts = new ArrayList<>();
    parts.add(new Formula.UnknownAtom(atom));
    atom.arguments().forEach(thing -> parts.add(Confirmation.seen(thing)));
    return new Formula.Or(List.of(formula, new Formula.And(parts)));
  }

  /** What is reckoned from places is known when all of them are. */
  private Formula orReckoned(Formula formula) {
    List<Formula> parts = new ArrayList<>();
    Leaves.of(
        formula,
        atom -> {
          if (reckoned.isReckoned(atom.predicate())) {
            parts.add(new Formula.UnknownAtom(atom));
            atom.arguments().forEach(of -> parts.add(reckoned.seenIfThing(of)));
          }
        },
        fluent -> {
          if (reckoned.isReckoned(fluent.name())) {
            parts.add(new Formula.UnknownNumber(fluent));
            fluent.arguments().forEach(of -> parts.add(reckoned.seenIfThing(of)));
          }
        });
    return parts.isEmpty() ? formula : new Formula.Or(List.of(formula, new Formula.And(parts)));
  }

  /** The facts, and that all has been seen of which the position is known. */
  public static Facts withWhatIsSeen(Facts facts, Snapshot now) {
    return new Facts() {
      @Override
      public Truth truth(Formula.Atom atom) {
        return Confirmation.isSeen(atom)
            ? Truth.of(now.value(POSITION, atom.arguments()).isPresent())
            : facts.truth(atom);
      }

      @Override
      public OptionalDouble number(Expression.Fluent fluent) {
        return facts.number(fluent);
      }

      @Override
      public double chanceStill(Formula.Atom atom) {
        return facts.chanceStill(atom);
      }

      @Override
      public Collection<Term.Name> individuals(String className) {
        return facts.individuals(className);
      }
    };
  }
}
