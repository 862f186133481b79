package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.ontology.vocabulary.Nearest;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/**
 * Tells what in a goal, a question or a fact is said wrongly in a home: what neither the home nor
 * its vocabulary know, and what they know as something else. Any thread may use it.
 */
public final class StatementCheck {
  private final Home home;
  private final String subject;

  /**
   * @param subject how sentences begin, such as {@code The goal}
   */
  public StatementCheck(Home home, String subject) {
    this.home = home;
    this.subject = subject;
  }

  /** The first fault, a sentence with its cure; empty when there is none. */
  public Optional<String> fault(Formula formula) {
    List<String> faults = new ArrayList<>();
    Leaves.of(
        formula,
        atom -> unknownNames(atom.arguments(), faults),
        fluent -> unknownNames(fluent.arguments(), faults));
    names(FreeVariables.of(formula), faults).check(formula);
    return faults.stream().findFirst();
  }

  /** The same of a single statement. */
  public Optional<String> fault(Fact fact) {
    List<String> faults = new ArrayList<>();
    names(FreeVariables.of(fact), faults).check(fact);
    return faults.stream().findFirst();
  }

  private NameCheck names(Collection<String> variables, List<String> faults) {
    return new NameCheck(
        home.vocabulary(),
        home.individuals()::containsKey,
        (name, className) ->
            HomeCheck.named(home.individuals(), name).classes().contains(className),
        variables,
        (problem, cure) -> faults.add("%s %s; %s.".formatted(subject, problem, cure)));
  }

  private void unknownNames(List<Term> terms, List<String> faults) {
    Collection<String> known = home.individuals().keySet();
    for (Term term : terms) {
      if (term instanceof Term.Name name && !known.contains(name.text())) {
        faults.add(
            "Nobody knows a thing named %s; %s."
                .formatted(
                    name.text(),
                    Nearest.cure(
                        name.text(), known, "name one of the home, such as " + example(known))));
      }
    }
  }

  private static String example(Collection<String> known) {
    return known.stream().limit(3).reduce((a, b) -> a + ", " + b).orElse("none (it is empty)");
  }
}
