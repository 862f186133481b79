package org.maestro.console.chat;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/** Whether a goal has to do with what somebody speaks of. */
final class Concern {
  private Concern() {}

  /** Whether the goal brings about any part of what is spoken of, or about as much of a number. */
  static boolean isOf(Formula goal, Formula spoken) {
    List<Formula> wanted = parts(goal);
    return parts(spoken).stream()
        .anyMatch(part -> wanted.stream().anyMatch(one -> isSame(one, part)));
  }

  private static List<Formula> parts(Formula formula) {
    if (formula instanceof Formula.And and) {
      List<Formula> all = new ArrayList<>();
      and.operands().forEach(operand -> all.addAll(parts(operand)));
      return all;
    } else if (formula instanceof Formula.Keep keep) {
      return parts(keep.body());
    } else if (formula instanceof Formula.Bound bound) {
      return parts(bound.goal());
    }
    return List.of(formula);
  }

  private static boolean isSame(Formula one, Formula other) {
    return one.equals(other)
        || one instanceof Formula.Comparison first
            && other instanceof Formula.Comparison second
            && first.left() instanceof Expression.Fluent
            && first.left().equals(second.left())
            && isNothing(first) == isNothing(second);
  }

  /** That there is none of it is another matter than how much of it there is. */
  private static boolean isNothing(Formula.Comparison comparison) {
    return comparison.relation() == Formula.Relation.EQUAL
        && comparison.right() instanceof Expression.OfTerm value
        && value.term().equals(new Term.Number(0));
  }

  /** The things of which a formula speaks. */
  static Set<String> things(Formula formula) {
    Set<String> names = new LinkedHashSet<>();
    Leaves.of(
        formula,
        atom -> names(atom.arguments(), names),
        fluent -> names(fluent.arguments(), names));
    return names;
  }

  private static void names(List<Term> terms, Set<String> names) {
    terms.stream()
        .filter(Term.Name.class::isInstance)
        .forEach(name -> names.add(((Term.Name) name).text()));
  }
}
