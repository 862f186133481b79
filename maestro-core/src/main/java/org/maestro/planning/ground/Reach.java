package org.maestro.planning.ground;

/**
 * What may come to hold, or to lack, where nothing that once held or lacked ever ceases to: what it
 * excludes is excluded.
 */
public interface Reach {
  /**
   * Whether some fact of that predicate may hold at some time.
   *
   * @param pattern its objects, any where the number is below 0
   */
  boolean mayHold(int predicate, int[] pattern);

  /** Whether the fact of that predicate and these objects may lack at some time. */
  boolean mayLack(int predicate, int[] objects);
}
