package org.maestro.planning.problem;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;

/**
 * Backward relevance. A variable matters when a needed condition on it does not hold from the
 * start, or a relevant operator touches it; an operator is relevant when it changes a variable that
 * matters; what its precondition, its price and those changes read is needed in turn. Leaving all
 * others out loses no cheapest plan.
 */
public final class Relevance {
  private final Function<Object, Collection<Operator>> operatorsChanging;
  private final Set<Object> relevant = new LinkedHashSet<>();
  private final Set<Operator> operators = new LinkedHashSet<>();
  private final Map<Object, List<Change>> touched = new LinkedHashMap<>();
  private final Set<Object> dormant = new LinkedHashSet<>();
  private final Set<List<Change>> parts = Collections.newSetFromMap(new IdentityHashMap<>());
  private final Deque<Object> open = new ArrayDeque<>();

  /**
   * Starts with nothing needed.
   *
   * @param operatorsChanging gives all operators that change a {@link Variable} or {@link
   *     NumberVariable}
   */
  public Relevance(Function<Object, Collection<Operator>> operatorsChanging) {
    this.operatorsChanging = operatorsChanging;
  }

  /** Finds all that matters for the condition. */
  public void close(Condition goal) {
    need(goal);
    while (!open.isEmpty()) {
      Object target = open.remove();
      operatorsChanging.apply(target).forEach(this::accept);
      touched.getOrDefault(target, List.of()).forEach(this::needAllOf);
    }
  }

  /** Takes the operators and all that they read or change for relevant. */
  public void closeWithAll(Collection<Operator> all, Condition goal) {
    goal.forEachLeaf(this::activateVariables);
    for (Operator operator : all) {
      operator.precondition().forEachLeaf(this::activateVariables);
      operator.changes().forEach(change -> activate(change.target()));
      accept(operator);
    }
  }

  private void activateVariables(Condition leaf) {
    if (leaf instanceof Condition.Literal literal) {
      activate(literal.variable());
    } else if (leaf instanceof Condition.NumberKnown known) {
      activate(known.variable());
    } else {
      needLeaf(leaf);
    }
  }

  /** In a stable order. */
  Set<Operator> operators() {
    return operators;
  }

  /** The variables and number variables that matter, in a stable order. */
  Set<Object> variables() {
    return relevant;
  }

  /** The condition with what does not matter replaced by its constant truth. */
  Condition simplified(Condition condition) {
    if (condition instanceof Condition.All all) {
      return Condition.all(all.parts().stream().map(this::simplified).toList());
    } else if (condition instanceof Condition.Any any) {
      return Condition.any(any.parts().stream().map(this::simplified).toList());
    } else if (condition instanceof Condition.Literal literal
        && !relevant.contains(literal.variable())) {
      return Condition.Constant.of(literal.holdsFor(literal.variable().initialCode()));
    } else if (condition instanceof Condition.NumberKnown known
        && !relevant.contains(known.variable())) {
      return Condition.Constant.of(Quantity.isUnknown(known.variable().initial()) != known.known());
    }
    return condition;
  }

  private void accept(Operator operator) {
    if (!operators.add(operator)) {
      return;
    }
    need(operator.precondition());
    operator.price().cost().forEachVariable(this::activate);
    operator.price().seconds().forEachVariable(this::activate);
    for (List<Change> part : operator.parts()) {
      if (parts.add(part)) {
        part.forEach(this::touch);
      }
    }
  }

  private void touch(Change change) {
    Object target = change.target();
    touched.computeIfAbsent(target, absent -> new ArrayList<>()).add(change);
    if (relevant.contains(target)) {
      needAllOf(change);
    } else if (dormant.contains(target)) {
      activate(target);
    }
  }

  /** A change must happen exactly where it happened before: its condition matters both ways. */
  private void needAllOf(Change change) {
    change.condition().forEachLeaf(this::activateVariables);
    if (change instanceof Change.Adjust adjust) {
      adjust.value().forEachVariable(this::activate);
    }
  }

  private void need(Condition condition) {
    condition.forEachLeaf(this::needLeaf);
  }

  private void needLeaf(Condition leaf) {
    if (leaf instanceof Condition.Literal literal) {
      need(literal.variable(), literal.holdsFor(literal.variable().initialCode()));
    } else if (leaf instanceof Condition.NumberKnown known) {
      need(known.variable(), Quantity.isUnknown(known.variable().initial()) != known.known());
    } else if (leaf instanceof Condition.Compare compare) {
      compare.left().forEachVariable(this::activate);
      compare.right().forEachVariable(this::activate);
    }
  }

  private void need(Object target, boolean holdsAtFirst) {
    if (!holdsAtFirst || touched.containsKey(target)) {
      activate(target);
    } else {
      dormant.add(target);
    }
  }

  private void activate(Object target) {
    if (relevant.add(target)) {
      open.add(target);
    }
  }
}
