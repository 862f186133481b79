package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.maestro.planning.optimal.MultipleChoiceKnapsack.Option;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.settings.Setting;
import org.maestro.planning.settings.SettingSum;
import org.maestro.planning.settings.Threshold;

/**
 * Lower bounds of the cost to bring sums over (or under) their thresholds.
 *
 * <p>Sums that share much of their settings form a cluster, in which only the dearest of the
 * thresholds that a plan reaches is counted. Bounds of different clusters add up: each setting is
 * paid for in one cluster only, and is free in the others.
 */
final class ThresholdPrices {
  /** From this part of a setting's largest factor on, a sum belongs to its cluster. */
  private static final double SHARED = 0.25;

  private final Map<NumberVariable, SettingSum> sums;
  private final List<List<Threshold>> clusters = new ArrayList<>();
  private final Set<Setting> paying = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Map<NumberVector, double[][]> costs = new HashMap<>();

  ThresholdPrices(Map<NumberVariable, SettingSum> sums, Set<Threshold> thresholds) {
    this.sums = sums;
    Map<NumberVariable, Set<NumberVariable>> clusterOf = new LinkedHashMap<>();
    for (Threshold threshold : thresholds) {
      clusterOf.computeIfAbsent(
          threshold.variable(), variable -> new LinkedHashSet<>(List.of(variable)));
    }
    for (Map.Entry<NumberVariable, Set<NumberVariable>> a : clusterOf.entrySet()) {
      for (Map.Entry<NumberVariable, Set<NumberVariable>> b : clusterOf.entrySet()) {
        if (a.getValue() != b.getValue() && shareMuch(a.getKey(), b.getKey())) {
          Set<NumberVariable> joined = a.getValue();
          joined.addAll(b.getValue());
          clusterOf.entrySet().stream()
              .filter(member -> joined.contains(member.getKey()))
              .forEach(member -> member.setValue(joined));
        }
      }
    }
    for (Set<NumberVariable> members : new LinkedHashSet<>(clusterOf.values())) {
      clusters.add(thresholds.stream().filter(t -> members.contains(t.variable())).toList());
    }
    for (NumberVariable variable : clusterOf.keySet()) {
      sum(variable).parts().forEach(part -> paying.add(part.setting()));
    }
  }

  /** Every threshold is one of a sum. */
  private SettingSum sum(NumberVariable variable) {
    return Objects.requireNonNull(sums.get(variable));
  }

  private boolean shareMuch(NumberVariable a, NumberVariable b) {
    for (SettingSum.Part part : sum(a).parts()) {
      for (SettingSum.Part other : sum(b).parts()) {
        double smaller = Math.min(Math.abs(part.factor()), Math.abs(other.factor()));
        double larger = Math.max(Math.abs(part.factor()), Math.abs(other.factor()));
        if (part.setting().equals(other.setting()) && smaller >= SHARED * larger) {
          return true;
        }
      }
    }
    return false;
  }

  List<List<Threshold>> clusters() {
    return clusters;
  }

  /** Whether a threshold is reached by the setting, so that it is paid for here. */
  boolean paysFor(Setting setting) {
    return paying.contains(setting);
  }

  /**
   * For each cluster and each of its thresholds the bound; 0 when met, infinite when out of reach
   * by settings.
   */
  double[][] costs(NumberVector numbers) {
    double[][] known = costs.get(numbers);
    if (known == null) {
      known = computed(numbers);
      costs.put(numbers, known);
    }
    return known;
  }

  private double[][] computed(NumberVector numbers) {
    Map<Setting, Integer> payers = payers(numbers);
    double[][] result = new double[clusters.size()][];
    for (int i = 0; i < result.length; i++) {
      List<Threshold> cluster = clusters.get(i);
      result[i] = new double[cluster.size()];
      for (int j = 0; j < cluster.size(); j++) {
        result[i][j] = cost(cluster.get(j), i, payers, numbers);
      }
    }
    return result;
  }

  /**
   * Each setting is paid for by the cluster that it moves most, of those where something is
   * missing.
   */
  private Map<Setting, Integer> payers(NumberVector numbers) {
    Map<Setting, Integer> payers = new LinkedHashMap<>();
    Map<Setting, Double> largest = new LinkedHashMap<>();
    for (int i = 0; i < clusters.size(); i++) {
      for (Threshold threshold : clusters.get(i)) {
        double value = numbers.get(threshold.variable().index());
        if (Double.isFinite(value) && !threshold.isMetBy(value)) {
          for (SettingSum.Part part : sum(threshold.variable()).parts()) {
            double factor = Math.abs(part.factor());
            if (factor > largest.getOrDefault(part.setting(), 0.0)) {
              largest.put(part.setting(), factor);
              payers.put(part.setting(), i);
            }
          }
        }
      }
    }
    return payers;
  }

  private double cost(
      Threshold threshold, int cluster, Map<Setting, Integer> payers, NumberVector numbers) {
    double value = numbers.get(threshold.variable().index());
    if (Quantity.isUnknown(value)) {
      return Double.POSITIVE_INFINITY;
    } else if (Quantity.isAny(value) || threshold.isMetBy(value)) {
      return 0;
    }
    SettingSum sum = sum(threshold.variable());
    if (!threshold.isMetBy(sum.extreme(numbers, threshold.upward()))) {
      return Double.POSITIVE_INFINITY;
    }
    double needed = threshold.missing(value);
    List<List<Option>> groups = new ArrayList<>();
    for (SettingSum.Part part : sum.parts()) {
      double now = numbers.get(part.setting().variable().index());
      // Every setting of a sum that is missed is paid for somewhere.
      if (Objects.requireNonNull(payers.get(part.setting())) != cluster) {
        needed -= SettingSum.bestGain(part, now, threshold.upward());
      } else {
        groups.add(options(part, now, threshold.upward()));
      }
    }
    double least = MultipleChoiceKnapsack.leastCost(groups, needed);
    return Double.isFinite(least) ? least : 0;
  }

  private static List<Option> options(SettingSum.Part part, double now, boolean upward) {
    int from = part.setting().indexOf(now);
    List<Option> options = new ArrayList<>();
    for (int to = 0; to < part.setting().values().length; to++) {
      double gain = SettingSum.gain(part, now, part.setting().values()[to], upward);
      double cost = part.setting().distance()[from][to];
      if (gain > 0 && Double.isFinite(cost)) {
        options.add(new Option(gain, cost));
      }
    }
    return options;
  }
}
