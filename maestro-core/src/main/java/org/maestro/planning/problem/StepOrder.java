package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Effect.Assignment;

/**
 * The partial order of a sequence's steps: which must wait for which. A step waits for an earlier
 * one of the same member, and for an earlier one when either writes what the other reads or writes;
 * additions to one number may be made in any order. All orders that respect this lead to the same
 * end.
 */
public final class StepOrder {
  private StepOrder() {}

  /** For each step the positions of those it waits for, transitively reduced. */
  static List<Set<Integer>> predecessors(List<Operator> operators) {
    List<Set<Integer>> reduced = new ArrayList<>();
    List<Set<Integer>> all = new ArrayList<>();
    for (int later = 0; later < operators.size(); later++) {
      Set<Integer> direct = new TreeSet<>();
      Set<Integer> closure = new TreeSet<>();
      for (int earlier = later - 1; earlier >= 0; earlier--) {
        if (!closure.contains(earlier) && conflict(operators.get(earlier), operators.get(later))) {
          direct.add(earlier);
          closure.add(earlier);
          closure.addAll(all.get(earlier));
        }
      }
      reduced.add(direct);
      all.add(closure);
    }
    return reduced;
  }

  /** Whether the later one has to wait for the earlier one. */
  public static boolean conflict(Operator earlier, Operator later) {
    if (earlier.feature().member().equals(later.feature().member())) {
      return true;
    }
    for (Change change : earlier.changes()) {
      for (Change other : later.changes()) {
        if (change.target() == other.target() && !(isAddition(change) && isAddition(other))) {
          return true;
        }
      }
    }
    return writesWhatIsRead(earlier, later) || writesWhatIsRead(later, earlier);
  }

  private static boolean isAddition(Change change) {
    return change instanceof Change.Adjust adjust && adjust.assignment() != Assignment.ASSIGN;
  }

  private static boolean writesWhatIsRead(Operator writer, Operator reader) {
    Set<Object> read = reads(reader);
    return writer.changes().stream().anyMatch(change -> read.contains(change.target()));
  }

  /** What the operator adds to, in any order with others that do. */
  public static Set<Object> added(Operator operator) {
    Set<Object> targets = new LinkedHashSet<>();
    operator.changes().stream()
        .filter(StepOrder::isAddition)
        .forEach(change -> targets.add(change.target()));
    return targets;
  }

  /** What the operator changes otherwise. */
  public static Set<Object> assigned(Operator operator) {
    Set<Object> targets = new LinkedHashSet<>();
    operator.changes().stream()
        .filter(change -> !isAddition(change))
        .forEach(change -> targets.add(change.target()));
    return targets;
  }

  /** The parts of the state on which the operator depends. */
  public static Set<Object> reads(Operator operator) {
    Set<Object> read = new LinkedHashSet<>();
    collect(operator.precondition(), read);
    operator.price().cost().forEachVariable(read::add);
    for (Change change : operator.changes()) {
      collect(change.condition(), read);
      if (change instanceof Change.Adjust adjust) {
        adjust.value().forEachVariable(read::add);
      } else if (change instanceof Change.Find || change instanceof Change.Measure) {
        read.add(change.target());
      }
    }
    return read;
  }

  private static void collect(Condition condition, Set<Object> read) {
    condition.forEachLeaf(
        leaf -> {
          if (leaf instanceof Condition.Literal literal) {
            read.add(literal.variable());
          } else if (leaf instanceof Condition.NumberKnown known) {
            read.add(known.variable());
          } else if (leaf instanceof Condition.Compare compare) {
            compare.left().forEachVariable(read::add);
            compare.right().forEachVariable(read::add);
          }
        });
  }
}
