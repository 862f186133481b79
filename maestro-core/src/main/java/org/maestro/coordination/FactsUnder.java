package org.maestro.coordination;

import java.util.Map;
import java.util.TreeSet;
import org.maestro.knowledge.Snapshot;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** The ground facts under a precondition with their present values, as one comparable text. */
final class FactsUnder {

  private FactsUnder() {}

  static String of(Formula precondition, Map<String, Term> bindings, Snapshot snapshot) {
    TreeSet<String> texts = new TreeSet<>();
    Leaves.of(
        new Substitution(bindings).apply(precondition),
        atom -> {
          if (atom.isGround()) {
            texts.add(SlPrinter.print(atom) + "=" + snapshot.truth(atom));
          }
        },
        fluent -> {
          if (fluent.arguments().stream().allMatch(Term::isGround)) {
            texts.add(SlPrinter.print(fluent) + "=" + snapshot.number(fluent));
          }
        });
    return String.join(" ", texts);
  }
}
