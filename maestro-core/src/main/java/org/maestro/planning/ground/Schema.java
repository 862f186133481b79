package org.maestro.planning.ground;

import java.util.BitSet;
import java.util.List;

/**
 * An operator with parameters.
 *
 * @param place where it is written, for complaints: file, line and column
 * @param domains which objects each parameter may be
 * @param shown how many parameters, from the first, are named in a plan; the others are those of
 *     existential conditions
 * @param differences pairs of terms, and whether they have to be the same object or different ones
 * @param increases what is added to functions: the functions that are the cost among them
 */
public record Schema(
    String name,
    String place,
    List<BitSet> domains,
    int shown,
    List<Literal> conditions,
    List<Sameness> differences,
    List<Comparison> comparisons,
    List<Atom> additions,
    List<Atom> deletions,
    List<Increase> increases) {
  public Schema {
    domains = List.copyOf(domains);
    conditions = List.copyOf(conditions);
    differences = List.copyOf(differences);
    comparisons = List.copyOf(comparisons);
    additions = List.copyOf(additions);
    deletions = List.copyOf(deletions);
    increases = List.copyOf(increases);
  }

  /** Two terms that have to be the same object, or that must not. */
  public record Sameness(int first, int second, boolean same) {}

  /** An amount that is added to a function's value. */
  public record Increase(Atom function, Amount amount) {}
}
