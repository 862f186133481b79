package org.maestro.planning.settings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Effect.Assignment;

/**
 * A number that moves only together with settings, in proportion to each: the light of a zone, the
 * sum of its lamps. In every state its distance from the sum of factor times setting is the same.
 */
public record SettingSum(NumberVariable variable, List<Part> parts) {

  public record Part(Setting setting, double factor) {}

  /**
   * The sum that the variable is, if it is one.
   *
   * @param operators all that change the variable
   * @param settings with all operators that change them
   * @param settingOf the setting that an operator changes
   */
  static Optional<SettingSum> of(
      NumberVariable variable,
      List<Operator> operators,
      Map<Setting, List<Operator>> settings,
      Map<Operator, Setting> settingOf,
      NumberVector initial) {
    Set<Setting> moving = Collections.newSetFromMap(new IdentityHashMap<>());
    for (Operator operator : operators) {
      Setting setting = settingOf.get(operator);
      if (setting != null) {
        moving.add(setting);
      } else if (operator.changes().stream().anyMatch(c -> isAdjustOf(c, variable))) {
        return Optional.empty();
      }
    }
    Map<Setting, Double> factors = new LinkedHashMap<>();
    for (Map.Entry<Setting, List<Operator>> setting : settings.entrySet()) {
      if (moving.contains(setting.getKey())) {
        for (Operator operator : setting.getValue()) {
          double factor = factor(variable, operator, setting.getKey(), initial);
          Double before = factors.putIfAbsent(setting.getKey(), factor);
          if (Double.isNaN(factor) || before != null && Math.abs(before - factor) > 1e-6) {
            return Optional.empty();
          }
        }
      }
    }
    List<Part> parts = new ArrayList<>();
    factors.forEach(
        (setting, factor) -> {
          if (factor != 0) {
            parts.add(new Part(setting, factor));
          }
        });
    return parts.isEmpty()
        ? Optional.empty()
        : Optional.of(new SettingSum(variable, List.copyOf(parts)));
  }

  private static boolean isAdjustOf(Change change, NumberVariable variable) {
    return change instanceof Change.Adjust && change.target() == variable;
  }

  /** How much the number moves per unit of the setting, NaN when it does not move in proportion. */
  private static double factor(
      NumberVariable variable, Operator operator, Setting setting, NumberVector initial) {
    List<Change> moves =
        operator.changes().stream().filter(change -> isAdjustOf(change, variable)).toList();
    if (moves.isEmpty()) {
      return 0;
    }
    Change.Adjust move = (Change.Adjust) moves.get(0);
    if (moves.size() > 1
        || move.assignment() == Assignment.ASSIGN
        || move.condition() != Condition.Constant.TRUE
        || !Setting.readsOnly(move.value(), setting.variable())) {
      return Double.NaN;
    }
    double target = targetOf(operator, setting);
    double sign = move.assignment() == Assignment.INCREASE ? 1 : -1;
    double factor = Double.NaN;
    for (double value : setting.values()) {
      double moved = sign * move.value().value(initial.with(setting.variable().index(), value));
      if (value == target) {
        if (!(Math.abs(moved) <= 1e-9)) {
          return Double.NaN;
        }
      } else {
        double here = moved / (target - value);
        if (!Double.isFinite(here) || !Double.isNaN(factor) && Math.abs(here - factor) > 1e-6) {
          return Double.NaN;
        }
        factor = here;
      }
    }
    return factor;
  }

  private static double targetOf(Operator operator, Setting setting) {
    return operator.changes().stream()
        .filter(change -> isAdjustOf(change, setting.variable()))
        .map(change -> ((Change.Adjust) change).value())
        .mapToDouble(value -> Quantity.rounded(((NumberExpression.Constant) value).number()))
        .findFirst()
        .orElseThrow();
  }

  /** What the setting can add at best when the number is to go up or down, never negative. */
  public static double bestGain(Part part, double now, boolean upward) {
    double best = 0;
    int from = part.setting().indexOf(now);
    for (int to = 0; to < part.setting().values().length; to++) {
      if (Double.isFinite(part.setting().distance()[from][to])) {
        best = Math.max(best, gain(part, now, part.setting().values()[to], upward));
      }
    }
    return best;
  }

  public static double gain(Part part, double from, double to, boolean upward) {
    return (upward ? 1 : -1) * part.factor() * (to - from);
  }

  /** The highest (or lowest) number that all settings together can bring about. */
  public double extreme(NumberVector numbers, boolean upward) {
    double value = numbers.get(variable.index());
    for (Part part : parts) {
      double now = numbers.get(part.setting().variable().index());
      value += (upward ? 1 : -1) * bestGain(part, now, upward);
    }
    return Quantity.rounded(value);
  }
}
