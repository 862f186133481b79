package org.maestro.planning.grounding;

import java.util.List;
import java.util.function.IntFunction;
import java.util.function.IntUnaryOperator;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.problem.Operator;

/**
 * The features that may change what is wanted, and their operators that do, side by side: a search
 * asks for all of one want again and again, and looking each up among all of its feature costs more
 * than what is done with it. For one thread at a time.
 */
final class ChangersOfWant {
  private final List<Integer> features;
  private final @Nullable List<Operator>[] operators;
  private final int[] versions;

  /**
   * @param features by their numbers
   */
  @SuppressWarnings({"unchecked", "rawtypes"})
  ChangersOfWant(List<Integer> features) {
    this.features = List.copyOf(features);
    this.operators = new List[features.size()];
    this.versions = new int[features.size()];
  }

  List<Integer> features() {
    return features;
  }

  /**
   * The operators of one of the features.
   *
   * @param version of a feature: what was made of another one is of no more use
   * @param making finds them by the feature's number
   */
  List<Operator> operators(
      int index, IntUnaryOperator version, IntFunction<List<Operator>> making) {
    int feature = features.get(index);
    int now = version.applyAsInt(feature);
    List<Operator> known = operators[index];
    if (known == null || versions[index] != now) {
      known = making.apply(feature);
      operators[index] = known;
      versions[index] = now;
    }
    return known;
  }
}
