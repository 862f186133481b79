package org.maestro.bench;

import java.util.Collection;
import java.util.List;

/** The value below which a share of all measured ones lies. */
public final class Quantile {
  private Quantile() {}

  /**
   * @param values at least one, in any order
   * @param share from 0 to 1, the largest
   */
  public static double of(Collection<? extends Number> values, double share) {
    List<Double> sorted = values.stream().map(Number::doubleValue).sorted().toList();
    int index = (int) Math.ceil(share * sorted.size()) - 1;
    return sorted.get(Math.max(0, Math.min(sorted.size() - 1, index)));
  }
}
