package org.maestro.ontology.home;

import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;

/**
 * The private words of a home that somebody may not read, and what he is told instead of their
 * facts. Immutable.
 *
 * @param hidden names of predicates and fluents
 * @param reader all names by which he is known
 */
public record ReadingRights(Set<String> hidden, Set<String> reader) {
  /** Of who may read everything. */
  public static final ReadingRights ALL = new ReadingRights(Set.of(), Set.of());

  public ReadingRights {
    hidden = Set.copyOf(hidden);
    reader = Set.copyOf(reader);
  }

  /** Whether nothing is kept from him. */
  public boolean areWhole() {
    return hidden.isEmpty();
  }

  public boolean mayRead(String word) {
    return !hidden.contains(word);
  }

  /**
   * @param fact in MAESTRO-SL
   */
  public boolean mayReadFact(String fact) {
    return areWhole() || mayRead(word(fact));
  }

  /** Why the question is not answered; empty when it is. */
  public Optional<String> objection(Formula question) {
    Set<String> words = new TreeSet<>();
    if (!areWhole()) {
      Leaves.of(question, atom -> words.add(atom.predicate()), fluent -> words.add(fluent.name()));
    }
    return objection(words);
  }

  /**
   * The same of a fact that is asked about.
   *
   * @param fact in MAESTRO-SL
   */
  public Optional<String> objectionToFact(String fact) {
    return areWhole() ? Optional.empty() : objection(Set.of(word(fact)));
  }

  /** The same of what is told by these words, in one sentence. */
  public Optional<String> objection(Set<String> words) {
    return words.stream()
        .filter(hidden::contains)
        .sorted()
        .findFirst()
        .map(
            word ->
                "%1$s is private in this home, and no maestro:Permission lets %2$s read it; who keeps the home's file can state one with maestro:caller and maestro:reads."
                    .formatted(word, String.join(" or ", new TreeSet<>(reader))));
  }

  /** What is told with a list from which some were left out. */
  public static String leftOut(int number) {
    return number == 1
        ? "1 fact is private and left out."
        : number + " facts are private and left out.";
  }

  private static String word(String text) {
    Fact fact = SlParser.fact(text);
    if (fact instanceof Fact.Equation equation) {
      Expression.Fluent fluent = equation.fluent();
      return fluent.name();
    } else if (fact instanceof Fact.Holds holds) {
      return holds.atom().predicate();
    } else if (fact instanceof Fact.Excluded excluded) {
      return excluded.atom().predicate();
    }
    return ((Fact.Unknown) fact).atom().predicate();
  }
}
