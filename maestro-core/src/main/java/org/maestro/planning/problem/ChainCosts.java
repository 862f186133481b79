package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.function.ToDoubleFunction;

/**
 * The operators that a plan within a budget can use. Each step of a plan that leaves nothing out
 * helps another step, and that one yet another, up to the goal: the least cost of such a chain, the
 * step itself included, and what has to be paid before the step can be taken, is what a plan costs
 * at least that uses it. Found backwards from the goal, the cheapest chain first, so that an
 * operator out of budget need not even be made.
 */
public final class ChainCosts {

  /** Makes the operators that change a variable. */
  public interface Source {
    /**
     * All operators that bring an {@link VariableValue} or a {@link Departure} about, or change a
     * {@link Variable} or {@link NumberVariable}, as far as they cost no more than is left.
     *
     * @return the least cost of those that were left out because they cost more, infinite when
     *     there are none
     */
    double changing(Object want, double left, List<Operator> into);
  }

  /** Knows what has to be paid at least for other steps before an operator can be used. */
  public interface CostAhead {
    /**
     * What has to be paid; more than what is left need not be reckoned exactly.
     *
     * @param left of the budget
     */
    double of(Operator operator, double left);
  }

  /** A want whose turn comes when all chains that cost less have been followed. */
  private record Turn(double cost, long sequence, Object want) implements Comparable<Turn> {
    @Override
    public int compareTo(Turn other) {
      int byCost = Double.compare(cost, other.cost);
      return byCost != 0 ? byCost : Long.compare(sequence, other.sequence);
    }
  }

  /**
   * A change of an operator that is allowed.
   *
   * @param part of the operator's changes, in which it stands
   */
  private record Touch(List<Change> part, Change change) {}

  private final Source source;
  private final ToDoubleFunction<Operator> leastCost;
  private final CostAhead costAhead;
  private final double budget;
  private final Map<Object, Double> needed = new HashMap<>();
  private final Set<Object> active = new HashSet<>();
  private final Set<Object> watched = new HashSet<>();
  private final Map<Object, Set<Object>> dormant = new HashMap<>();
  private final Map<Operator, Double> chains = new LinkedHashMap<>();
  private final Map<Object, List<Touch>> touching = new HashMap<>();

  /** The least cost of a chain to an operator that has the part. */
  private final IdentityHashMap<List<Change>, Double> parts = new IdentityHashMap<>();

  private final Set<Object> lookedAt = new HashSet<>();
  private final PriorityQueue<Turn> queue = new PriorityQueue<>();
  private double beyond = Double.POSITIVE_INFINITY;
  private long sequence;

  /**
   * @param leastCost of an operator in any state
   * @param budget in cost units; may be infinite
   */
  public ChainCosts(
      Source source, ToDoubleFunction<Operator> leastCost, CostAhead costAhead, double budget) {
    this.source = source;
    this.leastCost = leastCost;
    this.costAhead = costAhead;
    this.budget = budget;
  }

  public ChainCosts follow(Condition goal) {
    need(goal, 0);
    while (!queue.isEmpty()) {
      Turn turn = queue.remove();
      if (turn.cost() > leastCostOf(turn.want())) {
        continue;
      }
      List<Operator> changing = new ArrayList<>();
      double cheapest = source.changing(turn.want(), budget - turn.cost(), changing);
      beyond = Math.min(beyond, turn.cost() + cheapest);
      for (Operator operator : changing) {
        accept(operator, turn.cost() + leastCost.applyAsDouble(operator));
      }
    }
    return this;
  }

  /** The variable of which something is wanted. */
  public static Object target(Object want) {
    if (want instanceof Departure departure) {
      return departure.variable();
    }
    return want instanceof VariableValue aim ? aim.variable() : want;
  }

  /** Whether a plan within the budget may use the operator. */
  boolean allows(Operator operator) {
    return chains.containsKey(operator);
  }

  /** All that a plan within the budget may use, in a stable order. */
  public Set<Operator> allowed() {
    return chains.keySet();
  }

  /** What a plan costs at least that uses the operator; infinite beyond the budget. */
  public double of(Operator operator) {
    return chains.getOrDefault(operator, Double.POSITIVE_INFINITY);
  }

  /** The budget from which on more operators may be of use; infinite when there are no more. */
  public double beyond() {
    return beyond;
  }

  /** The variables of which it mattered how they are at first. */
  public Set<Object> consulted() {
    Set<Object> consulted = new HashSet<>(lookedAt);
    needed.keySet().forEach(want -> consulted.add(target(want)));
    return consulted;
  }

  /** Of something that is needed. */
  private double leastCostOf(Object want) {
    return Objects.requireNonNull(needed.get(want));
  }

  private void lookAt(Condition leaf) {
    if (leaf instanceof Condition.Literal literal) {
      lookedAt.add(literal.variable());
    }
  }

  private void accept(Operator operator, double cost) {
    if (cost > budget) {
      beyond = Math.min(beyond, cost);
      return;
    }
    Double before = chains.get(operator);
    if (before != null && before <= cost) {
      return;
    }
    double whole = before == null ? cost + costAhead.of(operator, budget - cost) : cost;
    if (whole > budget) {
      beyond = Math.min(beyond, whole);
      operator.precondition().forEachLeaf(this::lookAt);
      return;
    }
    chains.put(operator, cost);
    need(operator.precondition(), cost);
    operator.price().cost().forEachVariable(variable -> activate(variable, cost));
    operator.price().seconds().forEachVariable(variable -> activate(variable, cost));
    for (List<Change> part : operator.parts()) {
      Double least = parts.get(part);
      if (least == null || cost < least) {
        parts.put(part, cost);
        part.forEach(change -> touch(change, part, least == null, cost));
      }
    }
  }

  private void touch(Change change, List<Change> part, boolean first, double cost) {
    Object target = change.target();
    if (first) {
      touching.computeIfAbsent(target, absent -> new ArrayList<>()).add(new Touch(part, change));
    }
    if (watched.contains(target)) {
      needAllOf(change, cost);
    }
    for (Object want : dormant.getOrDefault(target, Set.of())) {
      activate(want, leastCostOf(want));
    }
    dormant.remove(target);
  }

  private void needAllOf(Change change, double cost) {
    change.condition().forEachLeaf(leaf -> activateVariables(leaf, cost));
    if (change instanceof Change.Adjust adjust) {
      adjust.value().forEachVariable(variable -> activate(variable, cost));
    } else if (change instanceof Change.Find find
        && !new VariableValue(find.variable(), find.value()).isFindable()) {
      // Only what is not known can be found: something has to end what is known first.
      activate(find.variable(), cost);
    }
  }

  private void activateVariables(Condition leaf, double cost) {
    if (leaf instanceof Condition.Literal literal) {
      activate(literal.variable(), cost);
    } else if (leaf instanceof Condition.NumberKnown known) {
      activate(known.variable(), cost);
    } else {
      needLeaf(leaf, cost);
    }
  }

  private void need(Condition condition, double cost) {
    condition.forEachLeaf(leaf -> needLeaf(leaf, cost));
  }

  private void needLeaf(Condition leaf, double cost) {
    if (leaf instanceof Condition.Literal literal) {
      Variable variable = literal.variable();
      Object want =
          switch (literal.question()) {
            case IS -> new VariableValue(variable, literal.value());
            case IS_NOT -> new Departure(variable, literal.value());
            case UNKNOWN, NOT_UNKNOWN -> variable;
          };
      need(want, literal.holdsFor(variable.initialCode()), cost);
    } else if (leaf instanceof Condition.NumberKnown known) {
      need(known.variable(), Quantity.isUnknown(known.variable().initial()) != known.known(), cost);
    } else if (leaf instanceof Condition.Compare compare) {
      compare.left().forEachVariable(variable -> activate(variable, cost));
      compare.right().forEachVariable(variable -> activate(variable, cost));
    }
  }

  /** What holds at first matters once somebody may change it. */
  private void need(Object want, boolean holdsAtFirst, double cost) {
    if (!holdsAtFirst || active.contains(want) || touching.containsKey(target(want))) {
      activate(want, cost);
    } else {
      needed.merge(want, cost, Math::min);
      dormant.computeIfAbsent(target(want), absent -> new LinkedHashSet<>()).add(want);
    }
  }

  private void activate(Object want, double cost) {
    double before = needed.getOrDefault(want, Double.POSITIVE_INFINITY);
    if (active.add(want) || cost < before) {
      double least = Math.min(before, cost);
      needed.put(want, least);
      queue.add(new Turn(least, sequence++, want));
    }
    if (watched.add(target(want))) {
      for (Touch touch : touching.getOrDefault(target(want), List.of())) {
        needAllOf(touch.change(), Objects.requireNonNull(parts.get(touch.part())));
      }
    }
  }
}
