package org.maestro.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Finds the settings of a problem and the sums of them. */
final class SettingAnalysis {
  private final Map<Setting, List<Operator>> settings = new LinkedHashMap<>();
  private final Map<NumberVariable, SettingSum> sums = new LinkedHashMap<>();

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

  /** The settings that the operator changes: one at most. */
  List<Setting> settingsOf(Operator operator) {
    return settings.entrySet().stream()
        .filter(setting -> setting.getValue().contains(operator))
        .map(Map.Entry::getKey)
        .toList();
  }

  /** The least that the operator costs in any state. */
  double leastCost(Operator operator, NumberVector initial) {
    if (operator.price().cost().isConstant()) {
      return operator.price().cost(initial);
    }
    for (Setting setting : settingsOf(operator)) {
      double least = Double.POSITIVE_INFINITY;
      for (double value : setting.values()) {
        int index = setting.variable().index();
        double cost = operator.price().cost(initial.with(index, value));
        least = cost < least ? cost : least;
      }
      return least;
    }
    return 0;
  }

  /** The sum that the number is, or null. */
  SettingSum sum(NumberVariable variable) {
    return sums.get(variable);
  }

  Map<NumberVariable, SettingSum> sums() {
    return sums;
  }
}
