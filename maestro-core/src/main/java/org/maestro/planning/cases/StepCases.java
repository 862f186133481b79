package org.maestro.planning.cases;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Successors;
import org.maestro.planning.problem.Variable;
import org.maestro.sl.Effect.Assignment;
import org.maestro.sl.SlPrinter;

/**
 * The ways in which a step can go, each with the condition under which it does, and with effects
 * that then need no condition of their own.
 */
public final class StepCases {
  private static final int MOST_CASES = 2000;

  private final Operator operator;
  private final NumberRanges ranges;
  private final ClauseCompiler conditions;
  private final boolean timed;

  /**
   * One way.
   *
   * @param values of variables that have one afterwards
   * @param effects other facts that hold afterwards, or do not; all others stay as they are
   * @param increases what is added to sums
   * @param seconds how long it takes; 0 where nobody wants to know
   */
  public record Case(
      Clause condition,
      Map<Variable, Integer> values,
      Map<Clause.Fact, Boolean> effects,
      Map<NumberVariable, Double> increases,
      double cost,
      double seconds) {

    /** Whether all stays as it is. */
    public boolean isIdle() {
      return values.isEmpty() && effects.isEmpty() && increases.isEmpty();
    }

    /** With values spelled out: that no other one holds, and that none is open. */
    public Map<Clause.Fact, Boolean> allEffects() {
      Map<Clause.Fact, Boolean> all = new LinkedHashMap<>(effects);
      values.forEach(
          (variable, value) -> {
            for (int other = 0; other < variable.valueCount(); other++) {
              if (variable.observable()) {
                all.put(new Clause.Open(variable, other), false);
              }
              all.put(new Clause.Is(variable, other), other == value);
            }
          });
      return all;
    }

    private Case with(Clause stricter, Way way) {
      Map<Variable, Integer> allValues = new LinkedHashMap<>(values);
      allValues.putAll(way.values());
      Map<Clause.Fact, Boolean> all = new LinkedHashMap<>(effects);
      all.putAll(way.effects());
      return new Case(stricter, allValues, all, increases, cost, seconds);
    }
  }

  /** Some changes happen, under this condition. */
  private record Happening(Clause condition, List<Change> changes) {}

  /** A conditional effect on a variable: what becomes of it under a condition. */
  private record Way(
      Clause condition, Map<Variable, Integer> values, Map<Clause.Fact, Boolean> effects) {}

  public StepCases(Operator operator, NumberRanges ranges, ClauseCompiler conditions) {
    this(operator, ranges, conditions, false);
  }

  /**
   * @param timed whether ways that take differently long are to be told apart
   */
  public StepCases(
      Operator operator, NumberRanges ranges, ClauseCompiler conditions, boolean timed) {
    this.operator = operator;
    this.ranges = ranges;
    this.conditions = conditions;
    this.timed = timed;
  }

  /**
   * All ways.
   *
   * @throws NotCarriedException when there are too many
   */
  public List<Case> all() {
    List<Happening> happenings = new ArrayList<>();
    for (Clause clause : conditions.clauses(operator.precondition())) {
      happenings.add(new Happening(clause, List.of()));
    }
    for (Change change : operator.changes()) {
      happenings = split(happenings, change);
    }
    List<Case> cases = new ArrayList<>();
    for (Happening happening : happenings) {
      cases.addAll(cases(happening));
      refuse(cases.size());
    }
    return cases.stream().distinct().toList();
  }

  private void refuse(int cases) {
    if (cases > MOST_CASES) {
      throw new NotCarriedException(
          "PDDL cannot carry %s of %s: it can go in more than %d ways."
              .formatted(
                  operator.feature().type().name(), operator.feature().member(), MOST_CASES));
    }
  }

  private void refuseSum(NumberVariable number) {
    if (ranges.isSum(number)) {
      throw new NotCarriedException(
          "PDDL cannot carry how long %s of %s takes: it depends on %s, which amounts are added to."
              .formatted(
                  operator.feature().type().name(),
                  operator.feature().member(),
                  SlPrinter.print(number.fluent())));
    }
  }

  private List<Happening> split(List<Happening> happenings, Change change) {
    List<Clause> when = conditions.clauses(change.condition());
    List<Clause> whenNot = conditions.contrary(change.condition());
    List<Happening> split = new ArrayList<>();
    for (Happening happening : happenings) {
      for (Clause clause : Clause.product(List.of(happening.condition()), when)) {
        List<Change> more = new ArrayList<>(happening.changes());
        more.add(change);
        split.add(new Happening(clause, more));
      }
      for (Clause clause : Clause.product(List.of(happening.condition()), whenNot)) {
        split.add(new Happening(clause, happening.changes()));
      }
    }
    refuse(split.size());
    return split;
  }

  private List<Case> cases(Happening happening) {
    Set<NumberVariable> read = new LinkedHashSet<>();
    operator.price().cost().forEachVariable(read::add);
    if (timed) {
      operator.price().seconds().forEachVariable(this::refuseSum);
      operator.price().seconds().forEachVariable(read::add);
    }
    Set<Object> targets = new LinkedHashSet<>();
    for (Change change : happening.changes()) {
      targets.add(change.target());
      if (change instanceof Change.Adjust adjust) {
        adjust.value().forEachVariable(read::add);
      }
      if (change.target() instanceof NumberVariable number
          && !ranges.isSum(number)
          && isRead(number, happening.changes())) {
        read.add(number);
      }
    }
    List<Case> cases = new ArrayList<>();
    ranges.forEachChoice(
        read,
        numbers -> {
          double cost = operator.price().cost(numbers);
          if (Double.isFinite(cost)) {
            happening
                .condition()
                .and(ClauseCompiler.choice(read, numbers))
                .ifPresent(
                    clause -> cases.add(ofNumbers(clause, happening.changes(), numbers, cost)));
          }
        });
    List<Case> complete = cases;
    for (Object target : targets) {
      if (target instanceof Variable variable) {
        complete = withChanges(complete, variable, changesOf(variable, happening.changes()));
      }
    }
    return complete;
  }

  /** Whether what becomes of a number depends on what it was. */
  private static boolean isRead(NumberVariable number, List<Change> changes) {
    List<Change> all = changesOf(number, changes);
    return !(all.size() == 1
        && all.get(0) instanceof Change.Adjust adjust
        && adjust.assignment() == Assignment.ASSIGN);
  }

  private static List<Change> changesOf(Object target, List<Change> changes) {
    return changes.stream().filter(change -> change.target() == target).toList();
  }

  private Case ofNumbers(Clause clause, List<Change> changes, NumberVector numbers, double cost) {
    Map<Clause.Fact, Boolean> effects = new LinkedHashMap<>();
    Map<NumberVariable, Double> increases = new LinkedHashMap<>();
    Set<NumberVariable> targets = new LinkedHashSet<>();
    for (Change change : changes) {
      if (change.target() instanceof NumberVariable number) {
        targets.add(number);
      }
    }
    for (NumberVariable target : targets) {
      List<Change> own = changesOf(target, changes);
      if (ranges.isSum(target)) {
        double added = Successors.after(own, numbers.with(target.index(), 0), target);
        if (!Double.isFinite(added)) {
          throw new NotCarriedException(
              "PDDL cannot carry %s: something unknown may be added to it."
                  .formatted(SlPrinter.print(target.fluent())));
        }
        if (added != 0) {
          increases.put(target, added);
        }
      } else {
        double after = Successors.after(own, numbers, target);
        if (Double.compare(after, numbers.get(target.index())) != 0 || !isRead(target, changes)) {
          for (double value : ranges.of(target)) {
            effects.put(new Clause.Has(target, value), Double.compare(value, after) == 0);
          }
        }
      }
    }
    return new Case(
        clause, Map.of(), effects, increases, cost, timed ? operator.price().seconds(numbers) : 0);
  }

  private static List<Case> withChanges(List<Case> cases, Variable variable, List<Change> changes) {
    List<Way> ways = new ArrayList<>();
    collect(variable, changes, changes.size() - 1, Clause.EMPTY, ways);
    List<Case> split = new ArrayList<>();
    for (Case one : cases) {
      for (Way way : ways) {
        one.condition().and(way.condition()).ifPresent(clause -> split.add(one.with(clause, way)));
      }
    }
    return split;
  }

  /** The last value that is put, or found where it is not known, is the one that stays. */
  private static void collect(
      Variable variable, List<Change> changes, int last, Clause condition, List<Way> ways) {
    if (last < 0) {
      collectRemovals(variable, changes, condition, ways);
      return;
    }
    Change change = changes.get(last);
    if (change instanceof Change.Put put) {
      ways.add(new Way(condition, Map.of(variable, put.value()), Map.of()));
    } else if (change instanceof Change.Find find) {
      Clause.Open open = new Clause.Open(variable, find.value());
      condition
          .and(Clause.of(open, true))
          .ifPresent(clause -> ways.add(new Way(clause, Map.of(variable, find.value()), Map.of())));
      condition
          .and(Clause.of(open, false))
          .ifPresent(clause -> collect(variable, changes, last - 1, clause, ways));
    } else {
      collect(variable, changes, last - 1, condition, ways);
    }
  }

  private static void collectRemovals(
      Variable variable, List<Change> changes, Clause condition, List<Way> ways) {
    List<Integer> removed = new ArrayList<>();
    for (Change change : changes) {
      if (change instanceof Change.Remove remove && !removed.contains(remove.value())) {
        removed.add(remove.value());
      }
    }
    Map<Clause.Fact, Boolean> none = new LinkedHashMap<>();
    Clause otherwise = condition;
    boolean possible = true;
    for (int i = 0; i < removed.size(); i++) {
      Clause.Is is = new Clause.Is(variable, removed.get(i));
      if (!variable.observable() || !variable.functional()) {
        none.put(is, false);
      } else {
        List<Integer> later = removed.subList(i + 1, removed.size());
        condition
            .and(Clause.of(is, true))
            .ifPresent(clause -> ways.add(new Way(clause, Map.of(), unknownBut(variable, later))));
        var without = otherwise.and(Clause.of(is, false));
        possible &= without.isPresent();
        otherwise = without.orElse(otherwise);
      }
      if (variable.observable()) {
        none.put(new Clause.Open(variable, removed.get(i)), false);
      }
    }
    if (possible) {
      ways.add(new Way(otherwise, Map.of(), none));
    }
  }

  /** What was known is not any more: it may be anything but what was removed after it. */
  private static Map<Clause.Fact, Boolean> unknownBut(Variable variable, List<Integer> excluded) {
    Map<Clause.Fact, Boolean> effects = new LinkedHashMap<>();
    for (int value = 0; value < variable.valueCount(); value++) {
      effects.put(new Clause.Is(variable, value), false);
      effects.put(new Clause.Open(variable, value), !excluded.contains(value));
    }
    return effects;
  }
}
