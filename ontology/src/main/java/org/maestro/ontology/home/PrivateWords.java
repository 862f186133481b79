package org.maestro.ontology.home;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.TakenFrom;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;

/**
 * The words of a home whose facts are not for everybody: those that it calls private, and those
 * that follow from them (ADE, 4.1; A30, A57). Immutable.
 */
public final class PrivateWords {
  private final Vocabulary vocabulary;
  private final List<Permission> readers;
  private final Map<String, Script> scripts;
  private final Set<String> all;

  private PrivateWords(
      Vocabulary vocabulary, Map<String, Script> scripts, List<Permission> readers) {
    this.vocabulary = vocabulary;
    this.scripts = scripts;
    this.readers = readers;
    this.all = kept(word -> false);
  }

  public static PrivateWords of(Home home) {
    return new PrivateWords(
        home.vocabulary(),
        home.scripts(),
        home.of("Permission").stream()
            .map(Permission::of)
            .filter(permission -> !permission.reads().isEmpty())
            .toList());
  }

  /** All of them, by name. */
  public Set<String> all() {
    return all;
  }

  /** Those that a goal speaks of, or the scripts use that it asks for. */
  public Set<String> usedFor(Formula goal) {
    return used(new UsedWords(scripts).add(goal));
  }

  /**
   * The same, and those of what it is worth.
   *
   * @param benefit as it is stated
   */
  public Set<String> usedFor(Formula goal, Expression benefit) {
    return used(new UsedWords(scripts).add(goal).add(benefit));
  }

  private Set<String> used(UsedWords words) {
    Set<String> used = new TreeSet<>(words.all());
    used.retainAll(all);
    return used;
  }

  /**
   * What somebody may read. Where the home states no permission to read, the operator may, as he is
   * the one who could state it.
   *
   * @param caller all names by which he is known
   * @param isOperator whether he is at the machine that runs an open site
   */
  public ReadingRights of(Set<String> caller, boolean isOperator) {
    if (all.isEmpty() || readers.isEmpty() && isOperator) {
      return ReadingRights.ALL;
    }
    Set<String> permitted = new TreeSet<>();
    readers.stream()
        .filter(permission -> permission.isFor(caller))
        .forEach(permission -> permitted.addAll(permission.reads()));
    return new ReadingRights(kept(permitted::contains), caller);
  }

  /** What may be told where nobody knows who listens. */
  public ReadingRights ofAnybody() {
    return new ReadingRights(all, Set.of(Permission.ANYBODY));
  }

  /** What is private, and what follows from that, but for what is permitted by its own name. */
  private Set<String> kept(Predicate<String> isPermitted) {
    Set<String> kept = new TreeSet<>();
    boolean grows = true;
    while (grows) {
      grows = false;
      for (PredicateDeclaration word : vocabulary.predicates().values()) {
        boolean isKept = word.isPrivate() || from(word).stream().anyMatch(kept::contains);
        grows |= isKept && !isPermitted.test(word.name()) && kept.add(word.name());
      }
    }
    return Set.copyOf(kept);
  }

  private static Set<String> from(PredicateDeclaration word) {
    Set<String> from = new LinkedHashSet<>();
    word.derivedWhen().ifPresent(rule -> add(rule, from));
    word.observedWhen().ifPresent(rule -> add(rule, from));
    Optional<String> property = word.takenFrom().map(TakenFrom::property);
    property.ifPresent(from::add);
    return from;
  }

  private static void add(Formula rule, Set<String> words) {
    Leaves.of(rule, atom -> words.add(atom.predicate()), fluent -> words.add(fluent.name()));
  }
}
