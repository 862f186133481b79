package org.maestro.knowledge.belief;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * The facts that stand in the home and the descriptions: classes and properties of individuals.
 * Immutable.
 */
final class Described {

  private static final int PAIR = 2;

  private final Home home;
  private final Map<String, List<Term.Name>> byClass = new LinkedHashMap<>();
  private final Map<String, Map<Term, Set<Term>>> subjects = new ConcurrentHashMap<>();

  /** All that is the value of a property; null until it is asked for. */
  private volatile @Nullable Set<Term> values;

  Described(Home home) {
    this.home = home;
    List<Term.Name> all = new ArrayList<>();
    List<Individual> inOrder = new ArrayList<>(home.individuals().values());
    inOrder.sort(Comparator.comparingDouble(Individual::order).thenComparing(Individual::name));
    for (Individual individual : inOrder) {
      Term.Name name = new Term.Name(individual.name());
      all.add(name);
      for (String className : individual.classes()) {
        byClass.computeIfAbsent(className, key -> new ArrayList<>()).add(name);
      }
    }
    byClass.put("", all);
    byClass.replaceAll((className, names) -> List.copyOf(names));
  }

  Collection<Term.Name> individuals(String className) {
    return byClass.getOrDefault(className, List.of());
  }

  /**
   * Whether the atom speaks of a class: a class's name and one term, and no predicate of that name.
   */
  boolean isOfClass(Formula.Atom atom) {
    return atom.arguments().size() == 1
        && home.vocabulary().predicate(atom.predicate()).isEmpty()
        && (home.vocabulary().classes().containsKey(atom.predicate())
            || byClass.containsKey(atom.predicate()));
  }

  boolean isInstance(Term term, String className) {
    return properties(term).filter(i -> i.classes().contains(className)).isPresent();
  }

  boolean holds(Formula.Atom atom) {
    List<Term> arguments = atom.arguments();
    if (arguments.size() == 1) {
      return values(arguments.get(0), atom.predicate()).contains(new Term.Truth(true));
    }
    return arguments.size() == PAIR
        && (values(arguments.get(0), atom.predicate()).contains(arguments.get(1))
            || isSymmetric(atom.predicate())
                && values(arguments.get(1), atom.predicate()).contains(arguments.get(0)));
  }

  OptionalDouble number(String predicate, List<Term> arguments) {
    return arguments.size() == 1
        ? values(arguments.get(0), predicate).stream()
            .map(value -> value instanceof Term.Number number ? number : null)
            .filter(Objects::nonNull)
            .mapToDouble(Term.Number::value)
            .findFirst()
        : OptionalDouble.empty();
  }

  /** The values that the home gives a property of one individual. */
  List<Term> values(Term subject, String property) {
    return properties(subject)
        .map(individual -> individual.properties().getOrDefault(property, List.of()))
        .orElse(List.of());
  }

  /**
   * The terms for which the atom stands in the home.
   *
   * @param atom of one argument or two, ground but for the variable
   */
  Set<Term> related(Formula.Atom atom, Term.Variable variable) {
    List<Term> arguments = atom.arguments();
    if (arguments.size() == 1) {
      return subjects(atom.predicate(), new Term.Truth(true));
    }
    boolean isSubject = arguments.get(0).equals(variable);
    Term other = arguments.get(isSubject ? 1 : 0);
    Set<Term> related = new LinkedHashSet<>();
    if (isSubject || isSymmetric(atom.predicate())) {
      related.addAll(subjects(atom.predicate(), other));
    }
    if (!isSubject || isSymmetric(atom.predicate())) {
      related.addAll(values(other, atom.predicate()));
    }
    return related;
  }

  private Set<Term> subjects(String property, Term value) {
    return subjects.computeIfAbsent(property, this::subjectsByValue).getOrDefault(value, Set.of());
  }

  private Map<Term, Set<Term>> subjectsByValue(String property) {
    Map<Term, Set<Term>> byValue = new HashMap<>();
    for (Term.Name subject : individuals("")) {
      for (Term value : values(subject, property)) {
        byValue.computeIfAbsent(value, absent -> new LinkedHashSet<>()).add(subject);
      }
    }
    return byValue;
  }

  /** Those of which the home says the same, and of which it says nothing anywhere else. */
  List<List<Term.Name>> alike(Collection<Term.Name> individuals) {
    record Kind(Set<String> classes, Map<String, List<Term>> properties) {}
    Map<Kind, List<Term.Name>> alike = new LinkedHashMap<>();
    for (Term.Name name : individuals) {
      Individual individual = home.individuals().get(name.text());
      if (individual != null && !values().contains(name)) {
        Map<String, List<Term>> properties = new LinkedHashMap<>(individual.properties());
        properties.remove(Individual.ORDER);
        alike
            .computeIfAbsent(
                new Kind(individual.classes(), properties), absent -> new ArrayList<>())
            .add(name);
      }
    }
    return alike.values().stream().filter(names -> names.size() > 1).map(List::copyOf).toList();
  }

  private Set<Term> values() {
    Set<Term> known = values;
    if (known == null) {
      known = new HashSet<>();
      for (Individual individual : home.individuals().values()) {
        individual.properties().values().forEach(known::addAll);
      }
      values = known;
    }
    return known;
  }

  /** Whether the home says anything of the variable. */
  boolean describes(StateVariable variable) {
    return variable.arguments().size() <= PAIR
        && variable.arguments().stream()
            .findFirst()
            .filter(subject -> !values(subject, variable.predicate()).isEmpty())
            .isPresent();
  }

  Stream<Term.Name> names() {
    return individuals("").stream();
  }

  private boolean isSymmetric(String predicate) {
    return home.vocabulary()
        .predicate(predicate)
        .filter(PredicateDeclaration::symmetric)
        .isPresent();
  }

  private Optional<Individual> properties(Term term) {
    return term instanceof Term.Name name
        ? Optional.ofNullable(home.individuals().get(name.text()))
        : Optional.empty();
  }
}
