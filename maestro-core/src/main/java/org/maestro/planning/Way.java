package org.maestro.planning;

import java.util.BitSet;

/**
 * What some steps cost at least, and of which features they may be: steps of no feature in common
 * are different ones, and their costs add up.
 *
 * @param features by number; not to be changed
 */
record Way(double cost, BitSet features) {
  static final Way NOTHING = new Way(0, new BitSet());

  boolean isApartFrom(Way other) {
    return !features.intersects(other.features());
  }

  /** What both cost at least. */
  Way and(Way other) {
    if (other.cost() == 0) {
      return this;
    } else if (cost == 0) {
      return other;
    } else if (!isApartFrom(other)) {
      return cost >= other.cost() ? this : other;
    }
    BitSet both = (BitSet) features.clone();
    both.or(other.features());
    return new Way(cost + other.cost(), both);
  }

  /** Says no more than this and the other say. */
  Way or(Way other) {
    if (equals(other)) {
      return this;
    }
    BitSet either = (BitSet) features.clone();
    either.or(other.features());
    double least = Math.min(cost, other.cost());
    return least == 0 ? NOTHING : new Way(least, either);
  }
}
