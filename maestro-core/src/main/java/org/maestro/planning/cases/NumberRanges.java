package org.maestro.planning.cases;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.problem.Successors;
import org.maestro.sl.Effect.Assignment;
import org.maestro.sl.SlPrinter;

/**
 * The values that the numbers of a problem can have. Those with few are told one by one; a number
 * that is known and only has amounts added that depend on such numbers is a sum.
 */
public final class NumberRanges {
  private static final int MOST_VALUES = 40;

  private final GroundProblem problem;
  private final Map<NumberVariable, TreeSet<Double>> values = new HashMap<>();

  /** The sums are those that are not among {@link #values}. */
  private NumberRanges(GroundProblem problem) {
    this.problem = problem;
  }

  /**
   * The values of the problem's numbers, which are placed for it.
   *
   * @throws NotCarriedException when a number has too many, and is no sum
   */
  public static NumberRanges of(GroundProblem problem) {
    NumberRanges ranges = new NumberRanges(problem);
    for (NumberVariable variable : problem.numbers()) {
      ranges.values.put(variable, new TreeSet<>(List.of(variable.initial())));
    }
    while (ranges.grows()) {}
    ranges.check();
    return ranges;
  }

  public boolean isSum(NumberVariable variable) {
    return !values.containsKey(variable);
  }

  /** All values that a number can have which is no sum. */
  List<Double> of(NumberVariable variable) {
    return List.copyOf(values.get(variable));
  }

  private boolean grows() {
    boolean grew = false;
    for (Operator operator : problem.operators()) {
      Map<NumberVariable, List<Change.Adjust>> adjusted = new LinkedHashMap<>();
      for (Change change : operator.changes()) {
        if (change instanceof Change.Measure measure && values.containsKey(measure.variable())) {
          TreeSet<Double> known = values.get(measure.variable());
          grew |= known.contains(Quantity.UNKNOWN) && known.add(Quantity.ANY);
        } else if (change instanceof Change.Adjust adjust) {
          adjusted.computeIfAbsent(adjust.variable(), key -> new ArrayList<>()).add(adjust);
        }
      }
      for (Map.Entry<NumberVariable, List<Change.Adjust>> own : adjusted.entrySet()) {
        for (List<Change> some : parts(own.getValue())) {
          TreeSet<Double> known = values.get(own.getKey());
          grew |= known != null && grows(own.getKey(), known, some);
        }
      }
    }
    return grew;
  }

  /** Of several changes of one number by one step, those of which the conditions held happen. */
  private static List<List<Change>> parts(List<Change.Adjust> changes) {
    List<List<Change>> parts = new ArrayList<>();
    parts.add(List.of());
    for (Change change : changes) {
      for (List<Change> part : List.copyOf(parts)) {
        List<Change> longer = new ArrayList<>(part);
        longer.add(change);
        parts.add(longer);
      }
    }
    return parts.subList(1, parts.size());
  }

  /**
   * @param known the number's values so far
   * @param changes of the number, which all happen
   */
  private boolean grows(NumberVariable variable, Set<Double> known, List<Change> changes) {
    Set<NumberVariable> read = new LinkedHashSet<>();
    for (Change change : changes) {
      Change.Adjust adjust = (Change.Adjust) change;
      adjust.value().forEachVariable(read::add);
      if (adjust.assignment() != Assignment.ASSIGN) {
        read.add(variable);
      }
    }
    if (read.stream().anyMatch(this::isSum)) {
      return values.remove(variable) != null;
    }
    Set<Double> reached = new TreeSet<>();
    forEachChoice(read, numbers -> reached.add(Successors.after(changes, numbers, variable)));
    boolean grew = known.addAll(reached);
    if (known.size() > MOST_VALUES) {
      values.remove(variable);
    }
    return grew;
  }

  /** Hands on each choice of values for some numbers; the others are unknown. */
  void forEachChoice(Set<NumberVariable> chosen, Consumer<NumberVector> consumer) {
    double[] numbers = new double[problem.numbers().size()];
    Arrays.fill(numbers, Quantity.UNKNOWN);
    choose(new ArrayList<>(chosen), 0, numbers, consumer);
  }

  private void choose(
      List<NumberVariable> chosen, int next, double[] numbers, Consumer<NumberVector> consumer) {
    if (next == chosen.size()) {
      consumer.accept(new NumberVector(numbers.clone()));
      return;
    }
    int at = chosen.get(next).index();
    double before = numbers[at];
    for (double value : of(chosen.get(next))) {
      numbers[at] = value;
      choose(chosen, next + 1, numbers, consumer);
    }
    numbers[at] = before;
  }

  private void check() {
    for (NumberVariable variable : problem.numbers()) {
      if (isSum(variable) && Quantity.isUnknown(variable.initial())) {
        throw tooManyValues(variable);
      }
    }
    for (Operator operator : problem.operators()) {
      operator.price().cost().forEachVariable(this::refuseSum);
      for (Change change : operator.changes()) {
        if (change instanceof Change.Adjust adjust) {
          adjust.value().forEachVariable(this::refuseSum);
          if (adjust.assignment() == Assignment.ASSIGN) {
            refuseSum(adjust.variable());
          }
        }
      }
    }
  }

  private void refuseSum(NumberVariable variable) {
    if (isSum(variable)) {
      throw tooManyValues(variable);
    }
  }

  private static NotCarriedException tooManyValues(NumberVariable variable) {
    return new NotCarriedException(
        "PDDL cannot carry %s: it has too many values, and more than amounts that are added."
            .formatted(SlPrinter.print(variable.fluent())));
  }
}
