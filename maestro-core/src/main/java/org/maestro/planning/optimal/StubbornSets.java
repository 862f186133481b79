package org.maestro.planning.optimal;

import java.util.ArrayDeque;
import java.util.BitSet;
import java.util.Deque;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;
import org.maestro.sl.Effect.Assignment;

/**
 * The operators that are enough to go on with from a state, where many do not touch each other
 * (partial order reduction): else each order of theirs would be searched. A set is closed over what
 * its operators interfere with, and over what has to come before those that are not possible yet,
 * so that the first of its operators in any plan can just as well be the first of that plan (strong
 * stubborn sets, Wehrle and Helmert 2012). No plan loses but its order.
 */
final class StubbornSets {
  private final GroundProblem problem;
  private final Map<Object, BitSet> changing = new HashMap<>();
  private final IdentityHashMap<Condition, BitSet> enabling = new IdentityHashMap<>();
  private final Touch[] touches;
  private final BitSet[] interfering;

  /**
   * The parts of a state that an operator reads and changes.
   *
   * @param added numbers that are only increased or decreased: in any order the sum is the same
   */
  private record Touch(Set<Object> read, Set<Object> changed, Set<Object> added) {

    static Touch of(Operator operator) {
      Touch touch = new Touch(new HashSet<>(), new HashSet<>(), new HashSet<>());
      readBy(operator.precondition(), touch.read::add);
      operator.price().cost().forEachVariable(touch.read::add);
      for (Change change : operator.changes()) {
        readBy(change.condition(), touch.read::add);
        if (change instanceof Change.Adjust adjust) {
          adjust.value().forEachVariable(touch.read::add);
        }
        boolean adds =
            change instanceof Change.Adjust adjust && adjust.assignment() != Assignment.ASSIGN;
        (adds ? touch.added : touch.changed).add(change.target());
      }
      return touch;
    }

    boolean interferesWith(Touch other) {
      return meet(changed, other.read)
          || meet(added, other.read)
          || meet(read, other.changed)
          || meet(read, other.added)
          || meet(changed, other.changed)
          || meet(changed, other.added)
          || meet(added, other.changed);
    }

    private static boolean meet(Set<Object> some, Set<Object> others) {
      return (some.size() < others.size() ? some : others)
          .stream().anyMatch((some.size() < others.size() ? others : some)::contains);
    }
  }

  StubbornSets(GroundProblem problem) {
    this.problem = problem;
    List<Operator> operators = problem.operators();
    this.touches = new Touch[operators.size()];
    this.interfering = new BitSet[operators.size()];
    for (int i = 0; i < touches.length; i++) {
      touches[i] = Touch.of(operators.get(i));
      for (Change change : operators.get(i).changes()) {
        changing.computeIfAbsent(change.target(), absent -> new BitSet()).set(i);
      }
    }
  }

  /** The operators to go on with that are possible in a state that is no goal. */
  BitSet of(State state) {
    BitSet chosen = new BitSet();
    Deque<Integer> open = new ArrayDeque<>();
    add(necessary(problem.goal().condition(), state, chosen), chosen, open);
    BitSet possible = new BitSet();
    while (!open.isEmpty()) {
      int next = open.remove();
      Operator operator = problem.operators().get(next);
      if (Successors.isApplicable(operator, state)) {
        possible.set(next);
        add(interfering(next), chosen, open);
      } else if (operator.precondition().holds(state)) {
        add(changingPrice(operator), chosen, open);
      } else {
        add(necessary(operator.precondition(), state, chosen), chosen, open);
      }
    }
    return possible;
  }

  private static void add(BitSet operators, BitSet chosen, Deque<Integer> open) {
    operators.stream()
        .filter(operator -> !chosen.get(operator))
        .forEach(
            operator -> {
              chosen.set(operator);
              open.add(operator);
            });
  }

  /** One of these comes before the condition holds. The fewest new ones are chosen. */
  private BitSet necessary(Condition condition, State state, BitSet chosen) {
    BitSet fewest = null;
    int least = Integer.MAX_VALUE;
    for (Condition part : condition.conjuncts()) {
      if (!part.holds(state)) {
        BitSet operators = enabling.computeIfAbsent(part, this::enabling);
        int added = operators.cardinality() - both(operators, chosen);
        if (added < least) {
          least = added;
          fewest = operators;
        }
      }
    }
    return Objects.requireNonNull(fewest, "the condition holds already");
  }

  private static int both(BitSet some, BitSet others) {
    BitSet both = (BitSet) some.clone();
    both.and(others);
    return both.cardinality();
  }

  private BitSet enabling(Condition condition) {
    BitSet operators = new BitSet();
    readBy(
        condition,
        target -> {
          BitSet all = changing.get(target);
          if (all != null) {
            operators.or(all);
          }
        });
    if (condition instanceof Condition.Literal literal
        && literal.question() == Condition.Question.IS) {
      for (int i = operators.nextSetBit(0); i >= 0; i = operators.nextSetBit(i + 1)) {
        operators.set(i, mayBring(problem.operators().get(i), literal));
      }
    }
    return operators;
  }

  private static boolean mayBring(Operator operator, Condition.Literal literal) {
    return operator.changes().stream()
        .filter(change -> change.target() == literal.variable())
        .anyMatch(
            change ->
                change instanceof Change.Remove
                    || ((Change.OfVariable) change).value() == literal.value());
  }

  private BitSet changingPrice(Operator operator) {
    BitSet operators = new BitSet();
    operator
        .price()
        .cost()
        .forEachVariable(number -> operators.or(changing.getOrDefault(number, new BitSet())));
    return operators;
  }

  private BitSet interfering(int operator) {
    if (interfering[operator] == null) {
      BitSet others = new BitSet();
      for (int i = 0; i < touches.length; i++) {
        others.set(i, i != operator && touches[operator].interferesWith(touches[i]));
      }
      interfering[operator] = others;
    }
    return interfering[operator];
  }

  private static void readBy(Condition condition, Consumer<Object> visitor) {
    condition.forEachLeaf(
        leaf -> {
          if (leaf instanceof Condition.Literal literal) {
            visitor.accept(literal.variable());
          } else if (leaf instanceof Condition.NumberKnown known) {
            visitor.accept(known.variable());
          } else if (leaf instanceof Condition.Compare compare) {
            compare.left().forEachVariable(visitor::accept);
            compare.right().forEachVariable(visitor::accept);
          }
        });
  }
}
