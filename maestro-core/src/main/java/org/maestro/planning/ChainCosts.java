package org.maestro.planning;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.function.ToDoubleFunction;

/**
 * Which operators a plan within a budget can use. Each step of a plan that leaves nothing out helps
 * another step, and that one yet another, up to the goal: the least cost of such a chain, the step
 * itself included, and what has to be paid before the step can be taken, is what a plan costs at
 * least that uses it. Found backwards from the goal, the cheapest chain first, so that an operator
 * out of budget need not even be made.
 */
final class ChainCosts {

  /** Makes the operators that change a variable. */
  interface Source {
    /**
     * All operators that bring an {@link Aim} or an {@link End} about, or change a {@link Variable}
     * or {@link NumberVariable}, as far as they cost no more than is left.
     *
     * @param beside what has to be paid besides, for other steps
     * @return the least cost of those that were left out because they cost more, that besides
     *     included; infinite when there are none
     */
    double changing(Object want, double left, Way beside, List<Operator> into);
  }

  /** Knows what has to be paid for steps that are not on a chain. */
  interface OffChain {
    /** One that knows of none. */
    OffChain UNKNOWN =
        new OffChain() {
          @Override
          public Way ahead(Operator operator) {
            return Way.NOTHING;
          }

          @Override
          public Way beside(Condition condition, Condition leaf) {
            return Way.NOTHING;
          }
        };

    /** What comes before the operator. */
    Way ahead(Operator operator);

    /** What comes before a step with this condition, when that leaf is on the chain. */
    Way beside(Condition condition, Condition leaf);
  }

  /** A want whose turn comes when all chains that cost less have been followed. */
  private record Turn(double cost, long sequence, Object want, Way beside)
      implements Comparable<Turn> {
    @Override
    public int compareTo(Turn other) {
      int byCost = Double.compare(cost, other.cost);
      return byCost != 0 ? byCost : Long.compare(sequence, other.sequence);
    }
  }

  private record Touch(Operator operator, Change change) {}

  private final Source source;
  private final ToDoubleFunction<Operator> leastCost;
  private final OffChain offChain;
  private final double budget;
  private final Map<Object, Double> needed = new HashMap<>();
  private final Map<Object, Way> besides = new HashMap<>();
  private final Set<Object> active = new HashSet<>();
  private final Set<Object> watched = new HashSet<>();
  private final Map<Object, Set<Object>> dormant = new HashMap<>();
  private final Map<Operator, Double> chains = new LinkedHashMap<>();
  private final Map<Operator, Way> besideChains = new HashMap<>();
  private final Map<Object, List<Touch>> touching = new HashMap<>();
  private final Set<Object> lookedAt = new HashSet<>();
  private final PriorityQueue<Turn> queue = new PriorityQueue<>();
  private double beyond = Double.POSITIVE_INFINITY;
  private long sequence;

  /**
   * @param leastCost of an operator in any state
   * @param offChain what has to be paid at least for other steps
   * @param budget in cost units; may be infinite
   */
  ChainCosts(
      Source source, ToDoubleFunction<Operator> leastCost, OffChain offChain, double budget) {
    this.source = source;
    this.leastCost = leastCost;
    this.offChain = offChain;
    this.budget = budget;
  }

  ChainCosts follow(Condition goal) {
    need(goal, 0, Way.NOTHING);
    while (!queue.isEmpty()) {
      Turn turn = queue.remove();
      Way beside = besides.get(turn.want());
      if (turn.cost() > needed.get(turn.want()) || !beside.equals(turn.beside())) {
        continue;
      }
      List<Operator> changing = new ArrayList<>();
      double cheapest = source.changing(turn.want(), budget - turn.cost(), beside, changing);
      beyond = Math.min(beyond, turn.cost() + cheapest);
      for (Operator operator : changing) {
        accept(operator, turn.cost() + leastCost.applyAsDouble(operator), beside);
      }
    }
    return this;
  }

  private static Object target(Object want) {
    if (want instanceof Aim aim) {
      return aim.variable();
    }
    return want instanceof End end ? end.variable() : want;
  }

  /** Whether a plan within the budget may use the operator. */
  boolean allows(Operator operator) {
    return chains.containsKey(operator);
  }

  /** All that a plan within the budget may use, in a stable order. */
  Set<Operator> allowed() {
    return chains.keySet();
  }

  /** What a plan costs at least that uses the operator; infinite beyond the budget. */
  double of(Operator operator) {
    return chains.getOrDefault(operator, Double.POSITIVE_INFINITY);
  }

  /** The budget from which on more operators may be of use; infinite when there are no more. */
  double beyond() {
    return beyond;
  }

  /** The variables of which it mattered how they are at first. */
  Set<Object> consulted() {
    Set<Object> consulted = new HashSet<>(lookedAt);
    needed.keySet().forEach(want -> consulted.add(target(want)));
    return consulted;
  }

  private void lookAt(Condition leaf) {
    if (leaf instanceof Condition.Literal literal) {
      lookedAt.add(literal.variable());
    }
  }

  private void accept(Operator operator, double cost, Way beside) {
    Double before = chains.get(operator);
    Way besideBefore = besideChains.get(operator);
    double chain = before == null ? cost : Math.min(before, cost);
    Way least = besideBefore == null ? beside : weaker(besideBefore, beside);
    if (before != null && before <= cost && least.equals(besideBefore)) {
      return;
    }
    double whole = before == null ? cost + offChain.ahead(operator).and(beside).cost() : cost;
    if (whole > budget) {
      beyond = Math.min(beyond, whole);
      operator.precondition().forEachLeaf(this::lookAt);
      return;
    }
    chains.put(operator, chain);
    besideChains.put(operator, least);
    need(operator.precondition(), chain, least);
    operator.price().cost().forEachVariable(variable -> activate(variable, chain));
    operator.price().seconds().forEachVariable(variable -> activate(variable, chain));
    for (Change change : operator.changes()) {
      Object target = change.target();
      if (before == null) {
        touching
            .computeIfAbsent(target, absent -> new ArrayList<>())
            .add(new Touch(operator, change));
      }
      if (watched.contains(target)) {
        needAllOf(change, chain);
      }
      for (Object want : dormant.getOrDefault(target, Set.of())) {
        activate(want, needed.get(want), besides.get(want));
      }
      dormant.remove(target);
    }
  }

  private void needAllOf(Change change, double cost) {
    change.condition().forEachLeaf(leaf -> activateVariables(leaf, cost));
    if (change instanceof Change.Adjust adjust) {
      adjust.value().forEachVariable(variable -> activate(variable, cost));
    } else if (change instanceof Change.Find find
        && !new Aim(find.variable(), find.value()).isFindable()) {
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
      needLeaf(leaf, cost, Way.NOTHING);
    }
  }

  private void need(Condition condition, double cost, Way beside) {
    condition.forEachLeaf(
        leaf -> needLeaf(leaf, cost, beside.and(offChain.beside(condition, leaf))));
  }

  private void needLeaf(Condition leaf, double cost, Way beside) {
    if (leaf instanceof Condition.Literal literal) {
      Variable variable = literal.variable();
      need(want(literal), literal.holdsFor(variable.initialCode()), cost, beside);
    } else if (leaf instanceof Condition.NumberKnown known) {
      NumberVariable number = known.variable();
      need(number, Quantity.isUnknown(number.initial()) != known.known(), cost, beside);
    } else if (leaf instanceof Condition.Compare compare) {
      compare.left().forEachVariable(variable -> activate(variable, cost));
      compare.right().forEachVariable(variable -> activate(variable, cost));
    }
  }

  private static Object want(Condition.Literal literal) {
    return switch (literal.question()) {
      case IS -> new Aim(literal.variable(), literal.value());
      case IS_NOT -> new End(literal.variable(), literal.value());
      case UNKNOWN, NOT_UNKNOWN -> literal.variable();
    };
  }

  /** What holds at first matters once somebody may change it. */
  private void need(Object want, boolean holdsAtFirst, double cost, Way beside) {
    if (!holdsAtFirst || active.contains(want) || touching.containsKey(target(want))) {
      activate(want, cost, beside);
    } else {
      needed.merge(want, cost, Math::min);
      besides.merge(want, beside, ChainCosts::weaker);
      dormant.computeIfAbsent(target(want), absent -> new LinkedHashSet<>()).add(want);
    }
  }

  private void activate(Object want, double cost) {
    activate(want, cost, Way.NOTHING);
  }

  private void activate(Object want, double cost, Way beside) {
    Double before = needed.get(want);
    Way besideBefore = besides.get(want);
    Way weaker = besideBefore == null ? beside : weaker(besideBefore, beside);
    if (active.add(want) || cost < before || !weaker.equals(besideBefore)) {
      double least = before == null ? cost : Math.min(before, cost);
      needed.put(want, least);
      besides.put(want, weaker);
      queue.add(new Turn(least, sequence++, want, weaker));
    }
    if (watched.add(target(want))) {
      for (Touch touch : touching.getOrDefault(target(want), List.of())) {
        needAllOf(touch.change(), chains.get(touch.operator()));
      }
    }
  }

  /** Where there are many different ones, little is gained from what they have in common. */
  private static Way weaker(Way before, Way beside) {
    return before.equals(beside) ? before : Way.NOTHING;
  }
}
