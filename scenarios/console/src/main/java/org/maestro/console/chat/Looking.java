package org.maestro.console.chat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.wording.Said;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Goals that find out what nobody knows. */
final class Looking {
  private static final Term WHERE = new Term.Variable("where");

  private Looking() {}

  /**
   * The goal to find it out.
   *
   * @param question as it was asked
   * @return empty when nobody who is there could look
   */
  static Optional<String> goal(String question, Surroundings around) {
    return KnownGoal.formula(question, around.home().get())
        .flatMap(formula -> seen(formula, around))
        .map(Looking::known)
        .map(SlPrinter::print);
  }

  /** What somebody can see of it: itself, or where the thing is of which it speaks. */
  private static Optional<Formula> seen(Formula formula, Surroundings around) {
    Optional<String> what = what(formula);
    if (what.filter(predicate -> isSensed(predicate, around)).isPresent()) {
      return Optional.of(formula);
    }
    Map<String, List<Said>> words = around.home().get().wording().prepositions();
    return formula instanceof Formula.Atom atom
            && atom.arguments().size() == 2
            && atom.arguments().get(0).isGround()
        ? words.entrySet().stream()
            .filter(other -> isAlike(other.getValue(), words.get(atom.predicate())))
            .map(Map.Entry::getKey)
            .filter(other -> isSensed(other, around))
            .findFirst()
            .map(other -> new Formula.Atom(other, List.of(atom.arguments().get(0), WHERE)))
        : Optional.empty();
  }

  private static boolean isAlike(List<Said> some, @Nullable List<Said> others) {
    return others != null && some.stream().anyMatch(others::contains);
  }

  private static boolean isSensed(String predicate, Surroundings around) {
    return around.present().get().stream()
        .map(around.home().get().devices()::get)
        .anyMatch(device -> device != null && senses(device, predicate));
  }

  /** What is asked for, by its predicate. */
  private static Optional<String> what(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      return Optional.of(atom.predicate());
    }
    return formula instanceof Formula.Comparison comparison
            && comparison.left() instanceof Expression.Fluent fluent
        ? Optional.of(fluent.name())
        : Optional.empty();
  }

  private static boolean senses(Device device, String predicate) {
    return device.features().stream().anyMatch(feature -> senses(feature.effect(), predicate));
  }

  private static boolean senses(Effect effect, String predicate) {
    if (effect instanceof Effect.SenseAtom sensed) {
      return sensed.atom().predicate().equals(predicate);
    } else if (effect instanceof Effect.SenseNumber sensed) {
      return sensed.fluent().name().equals(predicate);
    } else if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(one -> senses(one, predicate));
    } else if (effect instanceof Effect.When when) {
      return senses(when.effect(), predicate);
    }
    return effect instanceof Effect.Forall forall && senses(forall.effect(), predicate);
  }

  /** It is so, or known not to be so; of a number, that it is known. */
  private static Formula known(Formula formula) {
    if (formula instanceof Formula.Comparison comparison
        && comparison.left() instanceof Expression.Fluent fluent
        && comparison.right() instanceof Expression.OfTerm value
        && value.term() instanceof Term.Variable) {
      return new Formula.Not(new Formula.UnknownNumber(fluent));
    }
    return FreeVariables.of(formula).isEmpty()
        ? new Formula.Or(List.of(formula, new Formula.Not(formula)))
        : formula;
  }
}
