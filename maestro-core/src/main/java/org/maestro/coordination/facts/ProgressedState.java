package org.maestro.coordination.facts;

import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Facts as they would be after changes. */
public final class ProgressedState implements Facts {
  private final Facts before;
  private final Vocabulary vocabulary;
  private final Map<Formula.Atom, Boolean> truths = new LinkedHashMap<>();
  private final Map<Expression.Fluent, OptionalDouble> numbers = new LinkedHashMap<>();

  public ProgressedState(Facts before, List<Change> changes, Vocabulary vocabulary) {
    this.before = before;
    this.vocabulary = vocabulary;
    for (Change change : changes) {
      if (change instanceof Change.OfTruth truth) {
        truths.put(truth.atom(), truth.value());
      } else if (change instanceof Change.OfNumber number) {
        numbers.put(number.fluent(), number.value());
      }
    }
  }

  /** After the step's effect, as it is stated for planning; what it senses stays as it is. */
  public static ProgressedState of(Facts before, Vocabulary vocabulary, Step step) {
    return new ProgressedState(before, changes(before, step), vocabulary);
  }

  /** What the step would change. */
  public static List<Change> changes(Facts before, Step step) {
    return new Evaluation(before).changes(step.feature().effect(), step.values());
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    PredicateDeclaration declared = vocabulary.predicates().get(atom.predicate());
    return declared != null && declared.derivedWhen().isPresent()
        ? derived(declared, declared.derivedWhen().get(), atom.arguments())
        : plain(atom);
  }

  private Truth derived(PredicateDeclaration declared, Formula when, List<Term> arguments) {
    Map<String, Term> bindings = new HashMap<>();
    for (int i = 0; i < Math.min(arguments.size(), declared.parameters().size()); i++) {
      bindings.put(declared.parameters().get(i).name(), arguments.get(i));
    }
    Truth truth = new Evaluation(this).truth(when, bindings);
    return truth == Truth.UNKNOWN && !declared.observable() ? Truth.FALSE : truth;
  }

  private Truth plain(Formula.Atom atom) {
    Boolean direct = truths.get(atom);
    if (direct == null && is(atom, PredicateDeclaration::symmetric)) {
      direct = truths.get(mirrored(atom));
    }
    if (direct != null) {
      return Truth.of(direct);
    }
    if (is(atom, PredicateDeclaration::functional)
        && truths.entrySet().stream()
            .anyMatch(change -> change.getValue() && isOtherValue(change.getKey(), atom))) {
      return Truth.FALSE;
    }
    return before.truth(atom);
  }

  private boolean is(Formula.Atom atom, Predicate<PredicateDeclaration> property) {
    return vocabulary.predicate(atom.predicate()).filter(property).isPresent();
  }

  private static Formula.Atom mirrored(Formula.Atom atom) {
    return new Formula.Atom(
        atom.predicate(), List.of(atom.arguments().get(1), atom.arguments().get(0)));
  }

  private static boolean isOtherValue(Formula.Atom set, Formula.Atom asked) {
    List<Term> a = set.arguments();
    List<Term> b = asked.arguments();
    return set.predicate().equals(asked.predicate())
        && a.size() == b.size()
        && a.subList(0, a.size() - 1).equals(b.subList(0, b.size() - 1));
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    OptionalDouble changed = numbers.get(fluent);
    return changed != null ? changed : before.number(fluent);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return before.individuals(className);
  }
}
