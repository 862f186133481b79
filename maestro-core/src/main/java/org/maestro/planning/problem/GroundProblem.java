package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;

/**
 * A planning task without variables, reduced to what matters for its goal.
 *
 * @param variables those whose values make a state
 */
public record GroundProblem(
    List<Operator> operators,
    GroundGoal goal,
    List<Variable> variables,
    List<NumberVariable> numbers,
    State initial) {

  /**
   * The part of the operators that matters for the goal, with all that does not matter left out.
   */
  public static GroundProblem reduced(Relevance relevance, GroundGoal goal) {
    List<Operator> operators = new ArrayList<>();
    IdentityHashMap<List<Change>, List<Change>> keptOf = new IdentityHashMap<>();
    for (Operator operator : relevance.operators()) {
      List<Change> kept = new ArrayList<>();
      for (List<Change> part : operator.parts()) {
        kept.addAll(keptOf.computeIfAbsent(part, changes -> kept(changes, relevance)));
      }
      if (!kept.isEmpty()) {
        Condition precondition = relevance.simplified(operator.precondition());
        operators.add(operator.withChanges(kept).withPrecondition(precondition));
      }
    }
    return over(relevance, operators, goal.simplified(relevance));
  }

  private static List<Change> kept(List<Change> changes, Relevance relevance) {
    return changes.stream()
        .filter(change -> relevance.variables().contains(change.target()))
        .toList();
  }

  /** All operators as they are. */
  public static GroundProblem complete(Relevance relevance, GroundGoal goal) {
    return over(relevance, List.copyOf(relevance.operators()), goal);
  }

  private static GroundProblem over(
      Relevance relevance, List<Operator> operators, GroundGoal goal) {
    List<Variable> variables = new ArrayList<>();
    List<NumberVariable> numbers = new ArrayList<>();
    for (Object target : relevance.variables()) {
      if (target instanceof Variable variable) {
        variable.placeAt(variables.size());
        variables.add(variable);
      } else if (target instanceof NumberVariable number) {
        number.placeAt(numbers.size());
        numbers.add(number);
      }
    }
    int[] codes = variables.stream().mapToInt(Variable::initialCode).toArray();
    double[] values = numbers.stream().mapToDouble(NumberVariable::initial).toArray();
    State initial = new State(codes, new NumberVector(values));
    return new GroundProblem(
        List.copyOf(operators), goal, List.copyOf(variables), List.copyOf(numbers), initial);
  }

  /**
   * This problem, with its variables at their places in its states again: another problem over the
   * same variables may have placed them otherwise.
   */
  public GroundProblem placed() {
    for (int i = 0; i < variables.size(); i++) {
      variables.get(i).placeAt(i);
    }
    for (int i = 0; i < numbers.size(); i++) {
      numbers.get(i).placeAt(i);
    }
    return this;
  }

  /** The same goal with some of the operators, reduced again. */
  public GroundProblem with(List<Operator> remaining) {
    Relevance relevance = new Relevance(changing(remaining));
    relevance.close(goal.condition());
    return reduced(relevance, goal);
  }

  /** What a plan costs at least that uses an operator, for those within the budget. */
  public ChainCosts chains(ToDoubleFunction<Operator> leastCost, double budget) {
    Map<Object, List<Operator>> byWant = new HashMap<>();
    for (Operator operator : operators) {
      for (Change change : operator.changes()) {
        add(operator, change.target(), byWant);
        if (change instanceof Change.OfVariable of && !(change instanceof Change.Remove)) {
          add(operator, new VariableValue(of.variable(), of.value()), byWant);
        }
      }
    }
    ChainCosts.Source source =
        (want, left, into) -> {
          if (want instanceof Departure departure) {
            byWant.getOrDefault(departure.variable(), List.of()).stream()
                .filter(departure::isBroughtAboutBy)
                .forEach(into::add);
          } else {
            into.addAll(byWant.getOrDefault(want, List.of()));
          }
          return Double.POSITIVE_INFINITY;
        };
    return new ChainCosts(source, leastCost, (operator, left) -> 0, budget)
        .follow(goal.condition());
  }

  /**
   * The operators by what they change.
   *
   * @return gives those that change a variable, in their order
   */
  public static Function<Object, Collection<Operator>> changing(List<Operator> operators) {
    Map<Object, List<List<Change>>> partsOf = new HashMap<>();
    IdentityHashMap<List<Change>, List<Integer>> having = new IdentityHashMap<>();
    for (int i = 0; i < operators.size(); i++) {
      for (List<Change> part : operators.get(i).parts()) {
        if (!having.containsKey(part)) {
          part.stream()
              .map(Change::target)
              .distinct()
              .forEach(
                  target -> partsOf.computeIfAbsent(target, absent -> new ArrayList<>()).add(part));
        }
        having.computeIfAbsent(part, absent -> new ArrayList<>()).add(i);
      }
    }
    return target ->
        partsOf.getOrDefault(target, List.of()).stream()
            .flatMap(part -> Objects.requireNonNull(having.get(part)).stream())
            .sorted()
            .distinct()
            .map(operators::get)
            .toList();
  }

  private static void add(Operator operator, Object want, Map<Object, List<Operator>> byWant) {
    List<Operator> changing = byWant.computeIfAbsent(want, absent -> new ArrayList<>());
    if (changing.isEmpty() || !changing.get(changing.size() - 1).equals(operator)) {
      changing.add(operator);
    }
  }
}
