package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Point;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Tells what in a goal, a question, a fact, an effect or a number is said wrongly in a home: what
 * neither the home nor its vocabulary know, and what they know as something else. Any thread may
 * use it.
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
    return first(FreeVariables.of(fact), names -> names.check(fact));
  }

  /** The same of what a feature does; its variables are those of the feature. */
  public Optional<String> fault(Effect effect) {
    return first(FreeVariables.of(effect), names -> names.check(effect));
  }

  /** The same of a number. */
  public Optional<String> fault(Expression expression) {
    return first(FreeVariables.of(expression), names -> names.check(expression));
  }

  private Optional<String> first(Collection<String> variables, Consumer<NameCheck> check) {
    List<String> faults = new ArrayList<>();
    check.accept(names(variables, faults));
    return faults.stream().findFirst();
  }

  /** The same of a statement, but things that the home does not know may be of any class. */
  public Optional<String> misfit(Fact fact) {
    List<String> faults = new ArrayList<>();
    names(
            name -> true,
            (name, className) -> !home.individuals().containsKey(name) || isA(name, className),
            FreeVariables.of(fact),
            faults)
        .check(fact);
    return faults.stream().findFirst();
  }

  private boolean isA(String name, String className) {
    return HomeCheck.named(home.individuals(), name).classes().contains(className);
  }

  private NameCheck names(Collection<String> variables, List<String> faults) {
    return names(home.individuals()::containsKey, this::isA, variables, faults);
  }

  private NameCheck names(
      Predicate<String> individuals,
      BiPredicate<String, String> instances,
      Collection<String> variables,
      List<String> faults) {
    return new NameCheck(
        home.vocabulary(),
        individuals,
        instances,
        variables.stream().collect(Collectors.toMap(name -> name, name -> List.of())),
        this::known,
        (problem, cure) -> faults.add("%s %s; %s.".formatted(subject, problem, cure)));
  }

  /** The word that all use for one that a device has of its own; else the words that there are. */
  private String known(String kind, String word) {
    return home.devices().values().stream()
        .flatMap(device -> device.extension().synonyms().common(word).stream())
        .findFirst()
        .map(common -> "write %s, as it is called here".formatted(common))
        .orElseGet(() -> kind.equals("Individual") ? NameCheck.declare(kind, word) : known(kind));
  }

  /** The words that there are, and how one is written. */
  private String known(String kind) {
    if (kind.equals("Class")) {
      return "there are " + String.join(", ", home.vocabulary().classes().keySet());
    }
    boolean ofNumbers = kind.equals("Fluent");
    List<PredicateDeclaration> words =
        home.vocabulary().predicates().values().stream()
            .filter(word -> word.fluent() == ofNumbers)
            .toList();
    Optional<String> example =
        words.stream()
            .filter(PredicateDeclaration::observable)
            .flatMap(word -> example(word).stream())
            .findFirst();
    return "there are "
        + words.stream().map(PredicateDeclaration::name).collect(Collectors.joining(", "))
        + example.map(text -> ", each written as in " + text).orElse("");
  }

  /** The word with things of the home; empty when there are too few. */
  private Optional<String> example(PredicateDeclaration word) {
    Set<String> used = new LinkedHashSet<>();
    for (TypedVariable parameter : word.parameters()) {
      home.individuals().values().stream()
          .filter(
              thing ->
                  parameter.className().filter(name -> !thing.classes().contains(name)).isEmpty())
          .map(Individual::name)
          .filter(name -> !used.contains(name))
          .findFirst()
          .ifPresent(used::add);
    }
    return used.size() == word.parameters().size()
        ? Optional.of("(%s %s)".formatted(word.name(), String.join(" ", used)))
        : Optional.empty();
  }

  private void unknownNames(List<Term> terms, List<String> faults) {
    Collection<String> known = home.individuals().keySet();
    for (Term term : terms) {
      if (term instanceof Term.Name name
          && !known.contains(name.text())
          && Point.named(name.text()).isPresent()) {
        faults.add(
            "Nothing is known of the point %s, of which no goal speaks now; ask of the zone, or state the goal first."
                .formatted(name.text()));
      } else if (term instanceof Term.Name name && !known.contains(name.text())) {
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
