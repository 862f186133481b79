package org.maestro.planning.cases;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Variable;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * Makes a task over whole numbers of a home's ground problem: an operator for each case of each
 * step, and a fact for each proposition, and for each contrary, that a condition asks for. The
 * cheapest plan of the task costs what the cheapest plan of the problem costs.
 */
public final class GroundTaskCompiler {
  /** Costs and sums are told to this many decimal places at most. */
  private static final int PLACES = 9;

  /** Beyond it, sums of amounts do not fit in a long. */
  private static final double MOST = 1e6;

  /** A proposition, or its contrary. */
  private record Asked(Clause.Fact fact, boolean holds) {}

  /** One way of a step that matters. */
  private record Action(int operator, StepCases.Case oneCase) {}

  private final GroundProblem problem;
  private final List<Action> actions = new ArrayList<>();
  private final List<Clause> goals;
  private final int costPlaces;
  private final Map<Asked, Integer> facts = new LinkedHashMap<>();
  private final Map<Variable, Set<Clause.Fact>> askedOf = new HashMap<>();
  private final Map<Term, Integer> objects = new HashMap<>();
  private final Map<NumberVariable, Integer> sums = new LinkedHashMap<>();
  private final Map<GroundTask.Bound, Integer> bounds = new LinkedHashMap<>();

  private GroundTaskCompiler(GroundProblem problem) {
    this.problem = problem.placed();
    NumberRanges ranges = NumberRanges.of(problem);
    ClauseCompiler conditions = new ClauseCompiler(ranges);
    for (int o = 0; o < problem.operators().size(); o++) {
      for (StepCases.Case one :
          new StepCases(problem.operators().get(o), ranges, conditions).all()) {
        if (!one.isIdle()) {
          actions.add(new Action(o, one));
        }
      }
    }
    this.goals = conditions.clauses(problem.goal().condition());
    this.costPlaces =
        actions.stream()
            .mapToInt(action -> decimal(action.oneCase().cost()).scale())
            .reduce(0, Math::max);
  }

  /**
   * The task. The schema of an operator is the number of the step of the problem that it is a case
   * of, or the number of all steps where it stands for none; its arguments are who takes the step,
   * and the things that it names.
   *
   * @throws NotCarriedException when a part of the problem cannot be told in such a task
   */
  public static GroundTask compile(GroundProblem problem) {
    return new GroundTaskCompiler(problem).task();
  }

  private GroundTask task() {
    actions.forEach(action -> number(action.oneCase().condition()));
    goals.forEach(this::number);
    List<GroundOperator> operators = new ArrayList<>();
    actions.forEach(action -> operators.add(operator(action)));
    Conditions goal = goals.size() == 1 ? conditions(goals.get(0)) : anyOf(operators);
    return new GroundTask(
        facts.size(),
        sums.keySet().stream().mapToLong(sum -> scaled(sum.initial(), sum)).toArray(),
        List.copyOf(bounds.keySet()),
        operators,
        initial(),
        goal.needed(),
        goal.bounds(),
        BigDecimal.TEN.pow(costPlaces),
        goals.isEmpty(),
        names());
  }

  /** The numbers of what a clause asks for, ascending. */
  private record Conditions(int[] needed, int[] bounds) {}

  private void number(Clause clause) {
    clause.facts().forEach(this::number);
    for (Clause.Bound bound : clause.bounds()) {
      sums.putIfAbsent(bound.variable(), sums.size());
      bounds.putIfAbsent(bound(bound), bounds.size());
    }
  }

  private void number(Clause.Fact fact, boolean holds) {
    facts.putIfAbsent(new Asked(fact, holds), facts.size());
    Clause.variable(fact)
        .ifPresent(
            variable ->
                askedOf.computeIfAbsent(variable, absent -> new LinkedHashSet<>()).add(fact));
  }

  /** All that clauses ask for was numbered before. */
  private static <T> int numbered(Map<T, Integer> numbers, T asked) {
    return Objects.requireNonNull(numbers.get(asked));
  }

  private GroundTask.Bound bound(Clause.Bound bound) {
    int sum = numbered(sums, bound.variable());
    long number = scaled(bound.number(), bound.variable());
    return switch (bound.relation()) {
      case "<" -> new GroundTask.Bound(sum, Long.MIN_VALUE, number - 1);
      case "<=" -> new GroundTask.Bound(sum, Long.MIN_VALUE, number);
      case ">" -> new GroundTask.Bound(sum, number + 1, Long.MAX_VALUE);
      case ">=" -> new GroundTask.Bound(sum, number, Long.MAX_VALUE);
      default -> new GroundTask.Bound(sum, number, number);
    };
  }

  private Conditions conditions(Clause clause) {
    return new Conditions(
        clause.facts().entrySet().stream()
            .mapToInt(entry -> numbered(facts, new Asked(entry.getKey(), entry.getValue())))
            .sorted()
            .toArray(),
        clause.bounds().stream().mapToInt(one -> numbered(bounds, bound(one))).sorted().toArray());
  }

  private GroundOperator operator(Action action) {
    StepCases.Case one = action.oneCase();
    Conditions conditions = conditions(one.condition());
    Set<Integer> added = new TreeSet<>();
    Set<Integer> deleted = new TreeSet<>();
    FactsBefore before = new FactsBefore(one.condition());
    one.effects().forEach((fact, holds) -> become(fact, holds, before, added, deleted));
    one.values()
        .forEach(
            (variable, value) -> {
              Clause.Is is = new Clause.Is(variable, value);
              before.among(variable, askedOf.getOrDefault(variable, Set.of())).stream()
                  .filter(fact -> !fact.equals(is))
                  .forEach(fact -> become(fact, false, before, added, deleted));
              become(is, true, before, added, deleted);
            });
    Map<Integer, Long> changes = new TreeMap<>();
    one.increases()
        .forEach(
            (sum, amount) -> {
              Integer number = sums.get(sum);
              long scaled = scaled(amount, sum);
              if (number != null && scaled != 0) {
                changes.put(number, scaled);
              }
            });
    return new GroundOperator(
        action.operator(),
        objects(problem.operators().get(action.operator())),
        conditions.needed(),
        array(added),
        array(deleted),
        conditions.bounds(),
        array(changes.keySet()),
        changes.values().stream().mapToLong(change -> change).toArray(),
        decimal(one.cost()).setScale(costPlaces).unscaledValue().longValueExact());
  }

  private int[] objects(Operator step) {
    Set<Integer> named = new TreeSet<>();
    named.add(number(new Term.Name(step.feature().member())));
    step.bindings().values().stream()
        .filter(Term.Name.class::isInstance)
        .forEach(name -> named.add(number(name)));
    return array(named);
  }

  private int number(Term object) {
    return objects.computeIfAbsent(object, absent -> objects.size());
  }

  private void become(
      Clause.Fact fact,
      boolean holds,
      FactsBefore before,
      Set<Integer> added,
      Set<Integer> deleted) {
    Integer now = facts.get(new Asked(fact, holds));
    if (now != null) {
      added.add(now);
    }
    Integer contrary = facts.get(new Asked(fact, !holds));
    if (contrary != null && (holds || before.mayHold(fact))) {
      deleted.add(contrary);
    }
  }

  /** That one of several clauses was reached is a fact of its own. */
  private Conditions anyOf(List<GroundOperator> operators) {
    int reached = facts.size();
    facts.put(new Asked(new Clause.Said("goal-reached"), true), reached);
    int[] none = {};
    for (Clause clause : goals) {
      Conditions conditions = conditions(clause);
      operators.add(
          new GroundOperator(
              problem.operators().size(),
              none,
              conditions.needed(),
              new int[] {reached},
              none,
              conditions.bounds(),
              none,
              new long[0],
              0));
    }
    return new Conditions(new int[] {reached}, none);
  }

  private int[] initial() {
    return facts.entrySet().stream()
        .filter(entry -> holdsAtFirst(entry.getKey().fact()) == entry.getKey().holds())
        .mapToInt(Map.Entry::getValue)
        .sorted()
        .toArray();
  }

  private boolean holdsAtFirst(Clause.Fact fact) {
    if (fact instanceof Clause.Is is) {
      return problem.initial().code(is.variable()) == is.value();
    } else if (fact instanceof Clause.Open open) {
      return open.variable().isUnknown(problem.initial().code(open.variable()), open.value());
    } else if (fact instanceof Clause.Has has) {
      return Double.compare(problem.initial().number(has.variable()), has.value()) == 0;
    }
    return false;
  }

  private GroundTask.Names names() {
    List<Asked> inOrder = List.copyOf(facts.keySet());
    List<Operator> steps = problem.operators();
    return new GroundTask.Names() {
      @Override
      public String fact(int fact) {
        return inOrder.get(fact).toString();
      }

      @Override
      public String operator(GroundOperator operator) {
        int number = operator.schema();
        return number == steps.size() ? "" : steps.get(number).key().toString();
      }
    };
  }

  private static int[] array(Set<Integer> numbers) {
    return numbers.stream().mapToInt(number -> number).toArray();
  }

  private static long scaled(double number, NumberVariable variable) {
    if (!(Math.abs(number) <= MOST)) {
      throw new NotCarriedException(
          "PDDL cannot carry %s: it can be too large."
              .formatted(SlPrinter.print(variable.fluent())));
    }
    return decimal(number).setScale(PLACES).unscaledValue().longValueExact();
  }

  private static BigDecimal decimal(double number) {
    if (!(Math.abs(number) <= MOST)) {
      throw new NotCarriedException(
          "PDDL cannot carry %s as a whole number of billionths.".formatted(number));
    }
    return BigDecimal.valueOf(number).setScale(PLACES, RoundingMode.HALF_EVEN).stripTrailingZeros();
  }
}
