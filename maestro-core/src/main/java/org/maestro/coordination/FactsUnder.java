package org.maestro.coordination;

import java.util.Map;
import java.util.TreeSet;
import org.maestro.knowledge.Snapshot;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * The ground facts that a precondition speaks of, with their present values, as one comparable
 * text.
 */
final class FactsUnder {
  private final Snapshot snapshot;
  private final TreeSet<String> texts = new TreeSet<>();

  private FactsUnder(Snapshot snapshot) {
    this.snapshot = snapshot;
  }

  static String of(Formula precondition, Map<String, Term> bindings, Snapshot snapshot) {
    FactsUnder facts = new FactsUnder(snapshot);
    facts.add(new Substitution(bindings).apply(precondition));
    return String.join(" ", facts.texts);
  }

  private void add(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      add(atom);
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      add(unknown.atom());
    } else if (formula instanceof Formula.And and) {
      and.operands().forEach(this::add);
    } else if (formula instanceof Formula.Or or) {
      or.operands().forEach(this::add);
    } else if (formula instanceof Formula.Not not) {
      add(not.operand());
    } else if (formula instanceof Formula.Imply imply) {
      add(imply.premise());
      add(imply.conclusion());
    } else if (formula instanceof Formula.Comparison comparison) {
      add(comparison.left());
      add(comparison.right());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      add(unknown.fluent());
    }
  }

  private void add(Formula.Atom atom) {
    if (atom.isGround()) {
      texts.add(SlPrinter.print(atom) + "=" + snapshot.truth(atom));
    }
  }

  private void add(Expression expression) {
    if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::add);
    } else if (expression instanceof Expression.Fluent fluent
        && fluent.arguments().stream().allMatch(Term::isGround)) {
      texts.add(SlPrinter.print(fluent) + "=" + snapshot.number(fluent));
    }
  }
}
