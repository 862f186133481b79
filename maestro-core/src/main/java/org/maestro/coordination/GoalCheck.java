package org.maestro.coordination;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.TreeSet;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Refuses goals that speak of what neither home nor vocabulary know, before anybody is asked for
 * anything.
 */
final class GoalCheck {
  private final Home home;
  private final Vocabulary vocabulary;

  GoalCheck(Home home) {
    this.home = home;
    this.vocabulary = home.vocabulary();
  }

  void check(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      check(atom);
    } else if (formula instanceof Formula.And and) {
      and.operands().forEach(this::check);
    } else if (formula instanceof Formula.Or or) {
      or.operands().forEach(this::check);
    } else if (formula instanceof Formula.Not not) {
      check(not.operand());
    } else if (formula instanceof Formula.Imply imply) {
      check(imply.premise());
      check(imply.conclusion());
    } else if (formula instanceof Formula.Exists exists) {
      checkClasses(exists.variables());
      check(exists.body());
    } else if (formula instanceof Formula.Forall forall) {
      checkClasses(forall.variables());
      check(forall.body());
    } else if (formula instanceof Formula.Comparison comparison) {
      check(comparison.left());
      check(comparison.right());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      check(unknown.atom());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      check(unknown.fluent());
    } else if (formula instanceof Formula.Keep) {
      throw new InvalidGoalException(
          "A goal that is kept until cancelled, (keep ...), is not supported yet; state what is to be reached once.");
    }
  }

  private void check(Formula.Atom atom) {
    Optional<PredicateDeclaration> declared = vocabulary.predicate(atom.predicate());
    if (declared.isPresent()) {
      checkArity(atom.predicate(), declared.get(), atom.arguments().size());
    } else if (!vocabulary.classes().containsKey(atom.predicate())
        || atom.arguments().size() != 1) {
      throw unknown("predicate", atom.predicate(), predicateNames());
    }
    checkTerms(atom.arguments());
  }

  private void check(Expression expression) {
    if (expression instanceof Expression.OfTerm term) {
      checkTerms(List.of(term.term()));
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::check);
    } else if (expression instanceof Expression.Fluent fluent) {
      PredicateDeclaration declared =
          vocabulary
              .predicate(fluent.name())
              .orElseThrow(() -> unknown("quantity", fluent.name(), predicateNames()));
      checkArity(fluent.name(), declared, fluent.arguments().size());
      checkTerms(fluent.arguments());
    }
  }

  private void checkArity(String name, PredicateDeclaration declared, int given) {
    int wanted = declared.parameters().size();
    if (wanted != given) {
      throw new InvalidGoalException(
          "(%s ...) takes %d %s, not %d."
              .formatted(name, wanted, wanted == 1 ? "term" : "terms", given));
    }
  }

  private void checkClasses(List<TypedVariable> variables) {
    for (TypedVariable variable : variables) {
      variable
          .className()
          .filter(name -> !vocabulary.classes().containsKey(name))
          .ifPresent(
              name -> {
                throw unknown("class", name, vocabulary.classes().keySet());
              });
    }
  }

  private void checkTerms(List<Term> terms) {
    for (Term term : terms) {
      if (term instanceof Term.Name name && !home.individuals().containsKey(name.text())) {
        throw unknown("thing", name.text(), home.individuals().keySet());
      }
      if (term instanceof Term.Iri iri
          && home.individuals().values().stream().noneMatch(i -> i.iri().equals(iri.text()))) {
        throw unknown("thing", iri.text(), home.individuals().keySet());
      }
    }
  }

  private Collection<String> predicateNames() {
    TreeSet<String> names = new TreeSet<>(vocabulary.predicates().keySet());
    names.addAll(vocabulary.classes().keySet());
    return names;
  }

  private static InvalidGoalException unknown(String kind, String name, Collection<String> known) {
    return new InvalidGoalException(
        "Nobody knows a %s named %s; the nearest %s.".formatted(kind, name, nearest(name, known)));
  }

  private static String nearest(String name, Collection<String> known) {
    List<String> ordered = new ArrayList<>(known);
    ordered.sort(
        Comparator.<String>comparingInt(k -> distance(name.toLowerCase(), k.toLowerCase()))
            .thenComparing(Comparator.naturalOrder()));
    List<String> first = ordered.subList(0, Math.min(3, ordered.size()));
    return (first.size() == 1 ? "is " : "are ") + String.join(", ", first);
  }

  private static int distance(String a, String b) {
    int[] row = new int[b.length() + 1];
    for (int j = 0; j <= b.length(); j++) {
      row[j] = j;
    }
    for (int i = 1; i <= a.length(); i++) {
      int diagonal = row[0];
      row[0] = i;
      for (int j = 1; j <= b.length(); j++) {
        int above = row[j];
        int change = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
        row[j] = Math.min(change, Math.min(above, row[j - 1]) + 1);
        diagonal = above;
      }
    }
    return row[b.length()];
  }
}
