package org.maestro.ontology.vocabulary;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiConsumer;
import java.util.function.BiPredicate;
import java.util.function.BinaryOperator;
import java.util.function.Predicate;
import org.maestro.ontology.validation.Nearest;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Checks that formulas, effects and expressions use declared predicates, fluents, classes,
 * variables and individuals, as declared: an individual where its class is wanted, and never a text
 * or a number in its place. Each problem is told with its cure.
 */
public final class NameCheck {

  private final Vocabulary vocabulary;
  private final Predicate<String> individuals;
  private final BiPredicate<String, String> instances;
  private final Deque<String> variables;
  private final Map<String, List<String>> types;
  private final BinaryOperator<String> advice;
  private final BiConsumer<String, String> problems;

  /**
   * @param individuals which names may stand for individuals
   * @param instances whether an individual, named first, is of a class
   * @param variables those that may be used freely, with the classes and datatypes of which one
   *     fits; none where that is not known
   * @param advice what to do about an unknown word (second argument) that is like no other; its
   *     kind is Predicate, Fluent, Class or Individual
   * @param problems takes a problem and its cure
   */
  public NameCheck(
      Vocabulary vocabulary,
      Predicate<String> individuals,
      BiPredicate<String, String> instances,
      Map<String, List<String>> variables,
      BinaryOperator<String> advice,
      BiConsumer<String, String> problems) {
    this.vocabulary = vocabulary;
    this.individuals = individuals;
    this.instances = instances;
    this.variables = new ArrayDeque<>(variables.keySet());
    this.types = new HashMap<>(variables);
    this.advice = advice;
    this.problems = problems;
  }

  /** What is to be done where nothing is known of which a word may be a slip. */
  public static String declare(String kind, String word) {
    return switch (kind) {
      case "Class" -> "declare it as an owl:Class";
      case "Individual" -> "describe it in the home, or write ?" + word + " for a parameter";
      default -> "declare it as a maestro:" + kind;
    };
  }

  public void check(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      atom(atom);
    } else if (formula instanceof Formula.Exists exists) {
      under(exists.variables(), () -> check(exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      under(forall.variables(), () -> check(forall.body()));
    } else if (formula instanceof Formula.Comparison comparison) {
      check(comparison.left());
      check(comparison.right());
      alike(comparison.left(), comparison.right());
      alike(comparison.right(), comparison.left());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      atom(unknown.atom());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      check(unknown.fluent());
    } else if (formula instanceof Formula.Bound) {
      problems.accept(
          "is bound to a time or an event (%s)".formatted(SlPrinter.print(formula)),
          "state it as a goal of its own");
    } else {
      formula.parts().forEach(this::check);
    }
  }

  public void check(Effect effect) {
    if (effect instanceof Effect.Add add) {
      set(add.atom().predicate());
      atom(add.atom());
    } else if (effect instanceof Effect.Delete delete) {
      set(delete.atom().predicate());
      atom(delete.atom());
    } else if (effect instanceof Effect.All all) {
      all.effects().forEach(this::check);
    } else if (effect instanceof Effect.When when) {
      check(when.condition());
      check(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      under(forall.variables(), () -> check(forall.effect()));
    } else if (effect instanceof Effect.Change change) {
      set(change.fluent().name());
      check(change.fluent());
      check(change.value());
    } else if (effect instanceof Effect.SenseAtom sense) {
      atom(sense.atom());
    } else if (effect instanceof Effect.SenseNumber sense) {
      check(sense.fluent());
    }
  }

  public void check(Expression expression) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      check(ofTerm.term());
    } else if (expression instanceof Expression.Fluent fluent) {
      fluent(fluent.name(), fluent.arguments());
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::check);
    }
  }

  public void check(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      either(holds.atom());
    } else if (fact instanceof Fact.Excluded excluded) {
      atom(excluded.atom());
    } else if (fact instanceof Fact.Unknown unknown) {
      either(unknown.atom());
    } else if (fact instanceof Fact.Equation equation) {
      check(equation.fluent());
      check(equation.value());
    }
  }

  private void either(Formula.Atom atom) {
    if (vocabulary.isFluent(atom.predicate())) {
      fluent(atom.predicate(), atom.arguments());
    } else {
      atom(atom);
    }
  }

  private void atom(Formula.Atom atom) {
    String name = atom.predicate();
    PredicateDeclaration declared = vocabulary.predicates().get(name);
    if (declared != null && declared.fluent()) {
      problems.accept(
          "uses the number " + name + " as if it were true or false",
          "compare it: (>= (" + name + " ...) 1)");
    } else if (declared != null) {
      arguments(declared, atom.arguments());
    } else if (!vocabulary.classes().containsKey(name) || atom.arguments().size() != 1) {
      unknownPredicate(name, atom.arguments());
    } else if (!(atom.arguments().get(0) instanceof Term.Name)) {
      argument(atom.arguments().get(0), name, "(" + name + " ?x)");
    }
    atom.arguments().forEach(this::check);
  }

  private void unknownPredicate(String name, List<Term> arguments) {
    if (vocabulary.classes().containsKey(name)) {
      problems.accept(
          "gives the class " + name + " " + arguments.size() + " arguments",
          "write (" + name + " ?x)");
    } else {
      problems.accept(
          "uses the unknown predicate " + name,
          Nearest.cure(name, vocabulary.predicates().keySet(), advice.apply("Predicate", name)));
    }
  }

  private void fluent(String name, List<Term> arguments) {
    PredicateDeclaration declared = vocabulary.predicates().get(name);
    if (declared == null) {
      problems.accept(
          "uses the unknown fluent " + name,
          Nearest.cure(name, vocabulary.predicates().keySet(), advice.apply("Fluent", name)));
    } else if (!declared.fluent()) {
      problems.accept(
          "uses " + name + " as a number, which is true or false",
          "declare it as a maestro:Fluent");
    } else {
      arguments(declared, arguments);
    }
    arguments.forEach(this::check);
  }

  private void arguments(PredicateDeclaration declared, List<Term> arguments) {
    if (declared.parameters().size() != arguments.size()) {
      problems.accept(
          "gives " + declared.name() + " " + arguments.size() + " arguments",
          "write " + declared.form());
      return;
    }
    for (int i = 0; i < arguments.size(); i++) {
      Optional<String> wanted = declared.parameters().get(i).className();
      if (wanted.isPresent()) {
        argument(arguments.get(i), wanted.get(), declared.form());
      }
    }
  }

  /** A class of the vocabulary has individuals; what is of a datatype is none. */
  private void argument(Term term, String wanted, String form) {
    if (term instanceof Term.Variable variable) {
      List<String> fitting = types.getOrDefault(variable.name(), List.of());
      if (!fitting.isEmpty() && fitting.stream().noneMatch(type -> mayBe(type, wanted))) {
        problems.accept(
            "gives ?%s, a %s, where a %s is wanted"
                .formatted(variable.name(), String.join(" or ", fitting), wanted),
            "write " + form);
      }
    } else if (term instanceof Term.Name name) {
      if (individuals.test(name.text()) && !instances.test(name.text(), wanted)) {
        problems.accept(
            "names %s where a %s is wanted, and it is none".formatted(name.text(), wanted),
            "write " + form);
      }
    } else if (vocabulary.classes().containsKey(wanted)) {
      problems.accept(
          "gives %s where a %s is wanted, and that is no name"
              .formatted(SlPrinter.print(term), wanted),
          term instanceof Term.Text text && individuals.test(text.value())
              ? "write " + text.value() + " without quotes"
              : "write " + form);
    }
  }

  /** Whether something may be of both; a class that nobody declares is told elsewhere. */
  private boolean mayBe(String type, String wanted) {
    if (!vocabulary.classes().containsKey(wanted)) {
      return true;
    }
    return vocabulary.classes().containsKey(type)
        ? vocabulary.mayBeBoth(type, wanted)
        : !Parameter.isDatatype(type);
  }

  /** What stands beside a number in a comparison is one too. */
  private void alike(Expression number, Expression other) {
    if (!(number instanceof Expression.OfTerm ofNumber && !isNumber(ofNumber.term()))
        && other instanceof Expression.OfTerm ofTerm
        && !(ofTerm.term() instanceof Term.Variable)
        && !isNumber(ofTerm.term())) {
      problems.accept(
          "compares %s, a number, with %s"
              .formatted(SlPrinter.print(number), SlPrinter.print(ofTerm.term())),
          "write a number there");
    }
  }

  private static boolean isNumber(Term term) {
    return term instanceof Term.Number;
  }

  /** Effects set only what is neither derived nor computed. */
  private void set(String name) {
    PredicateDeclaration declared = vocabulary.predicates().get(name);
    if (declared != null
        && (declared.derivedWhen().isPresent() || declared.computedBy().isPresent())) {
      problems.accept("sets " + name + ", which follows from other facts", "set those facts");
    } else if (declared != null && declared.countedWhen().isPresent()) {
      problems.accept(
          "sets " + name + ", which is counted from what happens", "leave that to happen");
    }
  }

  public void check(Term term) {
    if (term instanceof Term.Variable variable && !variables.contains(variable.name())) {
      problems.accept(
          "uses ?" + variable.name() + ", which nothing binds",
          Nearest.cure(
              "?" + variable.name(),
              variables.stream().map(v -> "?" + v).toList(),
              "use a parameter, or quantify over it"));
    } else if (term instanceof Term.Name name && !individuals.test(name.text())) {
      problems.accept(
          "names " + name.text() + ", which is not described",
          advice.apply("Individual", name.text()));
    }
  }

  private void under(List<TypedVariable> quantified, Runnable inside) {
    Map<String, List<String>> outside = new HashMap<>(types);
    for (TypedVariable variable : quantified) {
      types.put(variable.name(), variable.className().map(List::of).orElse(List.of()));
      variable
          .className()
          .filter(name -> !vocabulary.classes().containsKey(name))
          .ifPresent(this::unknownClass);
      variables.push(variable.name());
    }
    inside.run();
    quantified.forEach(variable -> variables.pop());
    types.clear();
    types.putAll(outside);
  }

  private void unknownClass(String name) {
    problems.accept(
        "uses the unknown class " + name,
        Nearest.cure(name, vocabulary.classes().keySet(), advice.apply("Class", name)));
  }
}
