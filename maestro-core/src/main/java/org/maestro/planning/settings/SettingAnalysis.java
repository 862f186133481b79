package org.maestro.planning.settings;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;

/** Finds the settings of a problem and the sums of them. */
public final class SettingAnalysis {
  private final Map<Setting, List<Operator>> settings = new LinkedHashMap<>();
  private final Set<NumberVariable> variables = new HashSet<>();
  private final Map<Operator, Setting> settingOf = new HashMap<>();
  private final Map<NumberVariable, SettingSum> sums = new LinkedHashMap<>();

  public SettingAnalysis(GroundProblem problem) {
    NumberVector initial = problem.initial().numbers();
    Map<NumberVariable, List<Operator>> changing = changing(problem);
    changing.forEach(
        (number, operators) -> {
          Setting.of(number, operators, initial)
              .ifPresent(setting -> settings.put(setting, operators));
        });
    dropSharedOperators();
    settings.forEach(
        (setting, operators) -> {
          variables.add(setting.variable());
          operators.forEach(operator -> settingOf.put(operator, setting));
        });
    changing.forEach(
        (number, operators) -> {
          if (!isSetting(number)) {
            SettingSum.of(number, operators, settings, settingOf, initial)
                .ifPresent(sum -> sums.put(number, sum));
          }
        });
  }

  /** The operators that change each number, in the order of the problem's numbers. */
  private static Map<NumberVariable, List<Operator>> changing(GroundProblem problem) {
    Map<NumberVariable, List<Operator>> changing = new LinkedHashMap<>();
    problem.numbers().forEach(number -> changing.put(number, new ArrayList<>()));
    for (Operator operator : problem.operators()) {
      for (Change change : operator.changes()) {
        List<Operator> operators =
            change.target() instanceof NumberVariable number ? changing.get(number) : null;
        if (operators != null
            && (operators.isEmpty() || !operators.get(operators.size() - 1).equals(operator))) {
          operators.add(operator);
        }
      }
    }
    changing.values().removeIf(List::isEmpty);
    return changing;
  }

  /** An operator that sets two numbers at once would be paid for twice. */
  private void dropSharedOperators() {
    Set<Operator> seen = new HashSet<>();
    Set<Operator> shared = new HashSet<>();
    settings.values().forEach(all -> all.stream().filter(o -> !seen.add(o)).forEach(shared::add));
    settings.values().removeIf(all -> all.stream().anyMatch(shared::contains));
  }

  /** Whether the number is always known. */
  public boolean isSetting(NumberVariable variable) {
    return variables.contains(variable);
  }

  /** The setting that the operator changes, if it changes one. */
  public Optional<Setting> settingOf(Operator operator) {
    return Optional.ofNullable(settingOf.get(operator));
  }

  /** The least that the operator costs in any state. */
  public double leastCost(Operator operator, NumberVector initial) {
    if (operator.price().cost().isConstant()) {
      return operator.price().cost(initial);
    }
    Setting setting = settingOf.get(operator);
    if (setting == null) {
      return 0;
    }
    double least = Double.POSITIVE_INFINITY;
    for (double value : setting.values()) {
      double cost = operator.price().cost(initial.with(setting.variable().index(), value));
      least = cost < least ? cost : least;
    }
    return least;
  }

  /** The sum that the number is, if it is one. */
  public Optional<SettingSum> sum(NumberVariable variable) {
    return Optional.ofNullable(sums.get(variable));
  }

  public Map<NumberVariable, SettingSum> sums() {
    return sums;
  }
}
