package org.maestro.planning;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.MultipleChoiceKnapsack.Option;

/** Finds the settings of a problem and the sums of them, and prices the way to thresholds of these sums. */
final class SettingAnalysis {
  private final Map<Setting, List<Operator>> settings = new LinkedHashMap<>();
  private final Map<NumberVariable, SettingSum> sums = new LinkedHashMap<>();
  private final List<Threshold> thresholds = new ArrayList<>();
  private final Map<NumberVector, double[]> prices = new HashMap<>();

  SettingAnalysis(GroundProblem problem) {
    NumberVector initial = problem.initial().numbers();
    Map<NumberVariable, List<Operator>> changing = new LinkedHashMap<>();
    for (NumberVariable number : problem.numbers()) {
      List<Operator> operators =
          problem.operators().stream()
              .filter(o -> o.changes().stream().anyMatch(c -> c.target() == number))
              .toList();
      if (!operators.isEmpty()) {
        changing.put(number, operators);
      }
    }
    changing.forEach(
        (number, operators) -> {
          Setting setting = Setting.of(number, operators, initial);
          if (setting != null) {
            settings.put(setting, operators);
          }
        });
    dropSharedOperators();
    changing.forEach(
        (number, operators) -> {
          SettingSum sum =
              settings.keySet().stream().anyMatch(s -> s.variable() == number)
                  ? null
                  : SettingSum.of(number, operators, settings, initial);
          if (sum != null) {
            sums.put(number, sum);
          }
        });
  }

  /** An operator that sets two numbers at once would be paid for twice. */
  private void dropSharedOperators() {
    List<Setting> shared = new ArrayList<>();
    settings.forEach(
        (setting, operators) ->
            settings.forEach(
                (other, others) -> {
                  if (setting != other && operators.stream().anyMatch(others::contains)) {
                    shared.add(setting);
                  }
                }));
    shared.forEach(settings::remove);
  }

  /** Whether the number is always known. */
  boolean isSetting(NumberVariable variable) {
    return settings.keySet().stream().anyMatch(setting -> setting.variable() == variable);
  }

  /** Whether the operator sets a part of a sum for which a threshold was registered: the threshold pays for it. */
  boolean isPaidByThresholds(Operator operator) {
    return settings.entrySet().stream()
        .filter(setting -> setting.getValue().contains(operator))
        .anyMatch(
            setting ->
                thresholds.stream()
                    .flatMap(t -> sums.get(t.variable()).parts().stream())
                    .anyMatch(part -> part.setting() == setting.getKey()));
  }

  /** The least that the operator costs in any state. */
  double leastCost(Operator operator, NumberVector initial) {
    if (operator.price().cost().isConstant()) {
      return operator.price().cost(initial);
    }
    for (Map.Entry<Setting, List<Operator>> setting : settings.entrySet()) {
      if (setting.getValue().contains(operator)) {
        double least = Double.POSITIVE_INFINITY;
        for (double value : setting.getKey().values()) {
          int index = setting.getKey().variable().index();
          double cost = operator.price().cost(initial.with(index, value));
          least = cost < least ? cost : least;
        }
        return least;
      }
    }
    return operator.price().surcharge();
  }

  /** The sum that the number is, or null. */
  SettingSum sum(NumberVariable variable) {
    return sums.get(variable);
  }

  /** The registered thresholds; those of one number and direction stand together, nearest first. */
  List<Threshold> thresholds() {
    return thresholds;
  }

  /** Registers thresholds of sums; to be called once, before prices are asked. */
  void register(List<Threshold> found) {
    found.stream()
        .sorted(
            Comparator.comparingInt((Threshold t) -> t.variable().index())
                .thenComparing(Threshold::upward)
                .thenComparing((a, b) -> a.isBeyond(b) ? 1 : b.isBeyond(a) ? -1 : 0))
        .forEach(thresholds::add);
  }

  /** Whether the threshold follows another of the same number and direction. */
  boolean isChained(int index) {
    return index > 0
        && thresholds.get(index - 1).variable() == thresholds.get(index).variable()
        && thresholds.get(index - 1).upward() == thresholds.get(index).upward();
  }

  /**
   * For each threshold a lower bound of the cost to get there from the one before it; infinite when it cannot be reached. The bounds add up:
   * every setting is paid for by one number only.
   */
  double[] prices(NumberVector numbers) {
    double[] known = prices.get(numbers);
    if (known == null) {
      known = computed(numbers);
      prices.put(numbers, known);
    }
    return known;
  }

  private double[] computed(NumberVector numbers) {
    Map<Setting, SettingSum> payers = payers(numbers);
    double[] result = new double[thresholds.size()];
    double before = 0;
    for (int i = 0; i < result.length; i++) {
      before = isChained(i) ? before : 0;
      Threshold threshold = thresholds.get(i);
      double value = numbers.get(threshold.variable().index());
      if (Quantity.isUnknown(value)) {
        result[i] = Double.POSITIVE_INFINITY;
      } else if (!Quantity.isAny(value) && !threshold.isMetBy(value)) {
        SettingSum sum = sums.get(threshold.variable());
        if (!threshold.isMetBy(sum.extreme(numbers, threshold.upward()))) {
          result[i] = Double.POSITIVE_INFINITY;
        } else if (threshold.upward() || !isRaised(threshold.variable(), numbers)) {
          double cost = Math.max(before, leastCost(threshold, value, sum, payers, numbers));
          result[i] = cost - before;
          before = cost;
        }
      }
    }
    return result;
  }

  /** Where a number may have to go up and down, only the way up is counted: the way back might be cheaper than from here. */
  private boolean isRaised(NumberVariable variable, NumberVector numbers) {
    double value = numbers.get(variable.index());
    return thresholds.stream()
        .anyMatch(t -> t.variable() == variable && t.upward() && !t.isMetBy(value));
  }

  private Map<Setting, SettingSum> payers(NumberVector numbers) {
    Map<Setting, SettingSum> payers = new LinkedHashMap<>();
    Map<Setting, Double> largest = new LinkedHashMap<>();
    for (SettingSum sum : sums.values()) {
      double value = numbers.get(sum.variable().index());
      boolean active =
          Double.isFinite(value)
              && thresholds.stream()
                  .anyMatch(t -> t.variable() == sum.variable() && !t.isMetBy(value));
      if (active) {
        for (SettingSum.Part part : sum.parts()) {
          double factor = Math.abs(part.factor());
          if (factor > largest.getOrDefault(part.setting(), 0.0)) {
            largest.put(part.setting(), factor);
            payers.put(part.setting(), sum);
          }
        }
      }
    }
    return payers;
  }

  private static double leastCost(
      Threshold threshold,
      double value,
      SettingSum sum,
      Map<Setting, SettingSum> payers,
      NumberVector numbers) {
    double needed = threshold.missing(value);
    List<List<Option>> groups = new ArrayList<>();
    for (SettingSum.Part part : sum.parts()) {
      double now = numbers.get(part.setting().variable().index());
      if (payers.get(part.setting()) != sum) {
        needed -= SettingSum.bestGain(part, now, threshold.upward());
        continue;
      }
      int from = part.setting().indexOf(now);
      List<Option> options = new ArrayList<>();
      for (int to = 0; to < part.setting().values().length; to++) {
        double gain =
            SettingSum.gain(part, now, part.setting().values()[to], threshold.upward());
        double cost = part.setting().distance()[from][to];
        if (gain > 0 && Double.isFinite(cost)) {
          options.add(new Option(gain, cost));
        }
      }
      if (!options.isEmpty()) {
        groups.add(options);
      }
    }
    double least = MultipleChoiceKnapsack.leastCost(groups, needed);
    return Double.isFinite(least) ? least : 0;
  }
}
