package org.maestro.language.meaning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.maestro.language.reference.Relations;
import org.maestro.language.reference.Situation;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.wording.Construction;
import org.maestro.sl.Content;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * What is always asked back before it is done: what constructions mean that are to be confirmed, in
 * whichever words it is wished. Bound to one situation.
 */
final class Confirmed {
  private final Home home;
  private final Relations relations;
  private final List<Pattern> patterns = new ArrayList<>();

  /** What a construction makes so, with the classes of its roles. */
  private record Pattern(Formula formula, Map<String, String> classes) {}

  Confirmed(Situation situation) {
    this.home = situation.home();
    this.relations = new Relations(situation);
    for (Construction construction : home.wording().constructions()) {
      if (construction.confirm()) {
        Map<String, String> classes = new HashMap<>();
        construction.roles().forEach(role -> classes.put(role.name(), role.type()));
        construction.means().stream()
            .flatMap(Confirmed::goals)
            .flatMap(Confirmed::conjuncts)
            .forEach(formula -> patterns.add(new Pattern(formula, classes)));
      }
    }
  }

  /** Whether a part of what the message states is to be confirmed. */
  boolean isNeededBy(Content message) {
    return !patterns.isEmpty()
        && goals(message)
            .flatMap(Confirmed::conjuncts)
            .anyMatch(part -> patterns.stream().anyMatch(pattern -> isSo(pattern, part)));
  }

  private static Stream<Formula> goals(Content content) {
    return Stream.concat(
        Acts.goalOf(content).stream(),
        content.arguments().stream()
            .filter(Content.Argument.Nested.class::isInstance)
            .flatMap(nested -> goals(((Content.Argument.Nested) nested).content())));
  }

  private static Stream<Formula> conjuncts(Formula formula) {
    if (formula instanceof Formula.And and) {
      return and.operands().stream().flatMap(Confirmed::conjuncts);
    } else if (formula instanceof Formula.Keep keep) {
      return conjuncts(keep.body());
    } else if (formula instanceof Formula.Exists exists) {
      return conjuncts(exists.body());
    }
    return formula instanceof Formula.Forall forall ? conjuncts(forall.body()) : Stream.of(formula);
  }

  private boolean isSo(Pattern pattern, Formula said) {
    if (pattern.formula() instanceof Formula.Not one && said instanceof Formula.Not other) {
      return isSo(new Pattern(one.operand(), pattern.classes()), other.operand());
    }
    if (pattern.formula() instanceof Formula.Comparison one
        && one.left() instanceof Expression.Fluent expected) {
      // However much it is to be.
      return said instanceof Formula.Comparison other
          && other.left() instanceof Expression.Fluent fluent
          && expected.name().equals(fluent.name())
          && fits(expected.arguments(), fluent.arguments(), pattern.classes());
    }
    return pattern.formula() instanceof Formula.Atom one
        && said instanceof Formula.Atom other
        && one.predicate().equals(other.predicate())
        && one.arguments().size() == other.arguments().size()
        && fits(one.arguments(), other.arguments(), pattern.classes());
  }

  private boolean fits(List<Term> pattern, List<Term> said, Map<String, String> classes) {
    for (int i = 0; i < pattern.size(); i++) {
      if (!fits(pattern.get(i), said.get(i), classes)) {
        return false;
      }
    }
    return true;
  }

  /** Of any of a kind nobody knows that it is none of those. */
  private boolean fits(Term pattern, Term said, Map<String, String> classes) {
    if (!(pattern instanceof Term.Variable role)) {
      return pattern.equals(said);
    }
    String wanted = classes.getOrDefault(role.name(), "");
    return !(said instanceof Term.Name)
        || !home.vocabulary().classes().containsKey(wanted)
        || relations.isA(said, wanted);
  }
}
