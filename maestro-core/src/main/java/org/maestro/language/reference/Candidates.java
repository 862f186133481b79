package org.maestro.language.reference;

import java.util.Collection;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * The things of which what is said holds. Those are looked up that facts tell at once; only these,
 * or where there is no such index those of the class, are held against the whole description; and
 * that is remembered. Not safe for threads.
 */
final class Candidates {
  private final Home home;
  private final Facts facts;
  private final Relations relations;
  private final Map<Wanted, List<Term.Name>> found = new HashMap<>();

  /** What is said, and the class that is wanted. */
  private record Wanted(
      List<Term.Name> named, String kind, List<Formula> conditions, String className) {}

  Candidates(Situation situation, Relations relations) {
    this.home = situation.home();
    this.facts = situation.facts();
    this.relations = relations;
  }

  /** What fits the description and is of the class, in a stable order. */
  List<Term.Name> of(Description description, String className) {
    if (!description.tests().isEmpty()) {
      return sought(description, className);
    }
    Wanted wanted =
        new Wanted(
            description.named(), description.className(), description.conditions(), className);
    List<Term.Name> known = found.get(wanted);
    if (known == null) {
      known = sought(description, className);
      found.put(wanted, known);
    }
    return known;
  }

  private List<Term.Name> sought(Description description, String className) {
    Collection<Term.Name> all =
        description.named().isEmpty() ? likely(description, className) : description.named();
    boolean isAll =
        description.named().isEmpty()
            && description.conditions().isEmpty()
            && description.tests().isEmpty()
            && (className.isEmpty()
                || home.vocabulary().isA(kind(description, className), className));
    return isAll
        ? List.copyOf(all)
        : all.stream()
            .filter(name -> relations.isA(name, className))
            .filter(name -> isSo(description, name))
            .toList();
  }

  /** Whether all is so of the thing that is said, whatever it is called. */
  boolean isSo(Description description, Term.Name candidate) {
    Map<String, Term> bindings = Map.of(Description.IT, candidate);
    return description.conditions().stream()
            .allMatch(condition -> relations.holds(condition, bindings))
        && description.tests().stream().allMatch(test -> test.holds(candidate));
  }

  /** The narrower of the class that is said and the one that is wanted, where one is. */
  private String kind(Description description, String className) {
    String said = description.className();
    boolean isNarrower =
        !className.isEmpty() && (said.isEmpty() || home.vocabulary().isA(className, said));
    return isNarrower ? className : said;
  }

  private Collection<Term.Name> likely(Description description, String className) {
    String kind = kind(description, className);
    Collection<Term.Name> all = facts.individuals(kind);
    Optional<Set<Term>> fewest =
        description.conditions().stream()
            .map(this::told)
            .flatMap(Optional::stream)
            .min(Comparator.comparingInt(Set::size));
    if (fewest.isEmpty() || fewest.get().size() >= all.size()) {
      return all;
    }
    return fewest.get().stream()
        .filter(Term.Name.class::isInstance)
        .map(Term.Name.class::cast)
        .filter(name -> home.individuals().containsKey(name.text()) && relations.isA(name, kind))
        .sorted(Comparator.comparingDouble(this::order).thenComparing(Term.Name::text))
        .toList();
  }

  private double order(Term.Name name) {
    Individual individual = home.individuals().get(name.text());
    return individual == null ? Double.MAX_VALUE : individual.order();
  }

  /** Those of which a condition may hold, where the facts can tell that without trying each. */
  private Optional<Set<Term>> told(Formula condition) {
    if (condition instanceof Formula.Or or) {
      Set<Term> all = new LinkedHashSet<>();
      for (Formula part : or.operands()) {
        Optional<Set<Term>> some = told(part);
        if (some.isEmpty()) {
          return some;
        }
        all.addAll(some.get());
      }
      return Optional.of(all);
    }
    return condition instanceof Formula.Atom atom && isOfOne(atom)
        ? facts.candidates(atom, Description.IT)
        : Optional.empty();
  }

  /** Whether it says something of the candidate, once, and names all else. */
  private static boolean isOfOne(Formula.Atom atom) {
    return atom.arguments().stream().filter(Description.VARIABLE::equals).count() == 1
        && atom.arguments().stream().filter(Term.Variable.class::isInstance).count() == 1;
  }
}
