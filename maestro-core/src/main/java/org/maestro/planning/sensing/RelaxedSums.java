package org.maestro.planning.sensing;

import java.util.Arrays;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.maestro.planning.optimal.PropositionQueue;
import org.maestro.planning.optimal.RelaxedProblem;

/**
 * The cheapest way to each proposition of a relaxed problem, by the sum of what its conditions cost
 * (the additive heuristic of Bonet and Geffner, 2001), and what the steps on that way cost
 * together. Once reckoned, it is brought up to date for a few more truths at a time. Not
 * thread-safe.
 */
final class RelaxedSums {
  /** All propositions are asked for. */
  static final int ALL = -1;

  private static final int INITIAL = -1;
  private static final int NONE = -2;

  private final RelaxedProblem relaxed;
  private final int[] allOpen;
  private final double[] value;
  private final int[] supporter;
  private final double[] sums;
  private final int[] open;
  private final PropositionQueue queue = new PropositionQueue();
  private double[] costs = {};

  /** What each proposition counts in the sums; those that are reckoned with more truths alone. */
  private double[] counted = {};

  /**
   * One of the cheapest ways.
   *
   * @param sum what each condition costs by itself, added up: the same for all cheapest ways
   * @param cost of the steps, of which each counts once
   */
  record Way(double sum, double cost) {}

  RelaxedSums(RelaxedProblem relaxed) {
    this.relaxed = relaxed;
    this.allOpen =
        relaxed.actions().stream().mapToInt(action -> action.preconditions().length).toArray();
    this.value = new double[relaxed.propositionCount()];
    this.supporter = new int[value.length];
    this.sums = new double[allOpen.length];
    this.open = new int[allOpen.length];
  }

  /**
   * Reckons the ways from where these propositions are true.
   *
   * @param payersCosts as of {@link RelaxedProblem#costs}
   * @param last the only one that is asked for, with what it rests on; or {@link #ALL}
   */
  RelaxedSums from(boolean[] truths, double[] payersCosts, int last) {
    costs = payersCosts;
    counted = new double[0];
    Arrays.fill(value, Double.POSITIVE_INFINITY);
    Arrays.fill(supporter, NONE);
    Arrays.fill(sums, 0);
    System.arraycopy(allOpen, 0, open, 0, open.length);
    queue.clear();
    for (int i = 0; i < value.length; i++) {
      if (truths[i]) {
        reach(i, 0, INITIAL);
      }
    }
    while (!queue.isEmpty()) {
      double now = queue.leastKey();
      int proposition = queue.removeLeast();
      if (now > value[proposition]) {
        continue;
      }
      if (proposition == last) {
        return this;
      }
      for (int index : relaxed.consumers()[proposition]) {
        sums[index] += now;
        if (--open[index] == 0) {
          offer(index);
        }
      }
    }
    return this;
  }

  private void offer(int index) {
    RelaxedProblem.Action action = relaxed.actions().get(index);
    double own = action.payer() == RelaxedProblem.FREE ? 0 : costs[action.payer()];
    for (int added : action.additions()) {
      reach(added, sums[index] + own, index);
    }
  }

  private void reach(int proposition, double sum, int by) {
    if (sum < value[proposition]) {
      value[proposition] = sum;
      supporter[proposition] = by;
      queue.add(sum, proposition);
    }
  }

  /** What the steps cost that lead to all of these; each counts once. */
  double of(int... propositions) {
    Set<Integer> payers = new LinkedHashSet<>();
    Set<Integer> seen = new HashSet<>();
    for (int needed : propositions) {
      if (!collect(needed, payers, seen)) {
        return Double.POSITIVE_INFINITY;
      }
    }
    double sum = 0;
    for (int payer : payers) {
      sum += costs[payer];
    }
    return sum;
  }

  /** Whoever has to be paid for the proposition; each once. False when it is out of reach. */
  private boolean collect(int proposition, Set<Integer> payers, Set<Integer> seen) {
    if (supporter[proposition] == INITIAL || !seen.add(proposition)) {
      return true;
    }
    if (supporter[proposition] == NONE) {
      return false;
    }
    RelaxedProblem.Action action = relaxed.actions().get(supporter[proposition]);
    if (action.payer() != RelaxedProblem.FREE) {
      payers.add(action.payer());
    }
    for (int needed : action.preconditions()) {
      if (!collect(needed, payers, seen)) {
        return false;
      }
    }
    return true;
  }

  /** The way to the goal. */
  Way toGoal() {
    return new Way(value[relaxed.goal()], of(relaxed.goal()));
  }

  /**
   * The way to the goal where these are true besides; the ways stay as they were. All propositions
   * were asked for before.
   */
  Way toGoalWith(List<Integer> truths) {
    if (counted.length == 0) {
      counted = value.clone();
    }
    Undo undo = new Undo();
    queue.clear();
    for (int proposition : truths) {
      lower(proposition, 0, INITIAL, undo);
    }
    int goal = relaxed.goal();
    while (!queue.isEmpty() && queue.leastKey() < value[goal]) {
      double now = queue.leastKey();
      int proposition = queue.removeLeast();
      if (now > value[proposition]) {
        continue;
      }
      boolean isNew = counted[proposition] == Double.POSITIVE_INFINITY;
      double more = isNew ? now : now - counted[proposition];
      undo.counts(proposition);
      counted[proposition] = now;
      for (int index : relaxed.consumers()[proposition]) {
        undo.changes(index);
        sums[index] += more;
        open[index] -= isNew ? 1 : 0;
        if (open[index] == 0) {
          RelaxedProblem.Action action = relaxed.actions().get(index);
          double own = action.payer() == RelaxedProblem.FREE ? 0 : costs[action.payer()];
          for (int added : action.additions()) {
            lower(added, sums[index] + own, index, undo);
          }
        }
      }
    }
    Way way = toGoal();
    undo.all();
    return way;
  }

  private void lower(int proposition, double sum, int by, Undo undo) {
    if (sum < value[proposition]) {
      undo.values(proposition);
      reach(proposition, sum, by);
    }
  }

  /** What was changed for a few more truths, the last change last. */
  private final class Undo {
    private int[] places = new int[64];
    private double[] before = new double[64];
    private int[] besides = new int[64];
    private int size;

    private static final int VALUE = 0;
    private static final int COUNT = 1;
    private static final int ACTION = 2;

    void values(int proposition) {
      note(VALUE, proposition, value[proposition], supporter[proposition]);
    }

    void counts(int proposition) {
      note(COUNT, proposition, counted[proposition], 0);
    }

    void changes(int action) {
      note(ACTION, action, sums[action], open[action]);
    }

    private void note(int kind, int place, double number, int beside) {
      if (size == places.length) {
        places = Arrays.copyOf(places, 2 * size);
        before = Arrays.copyOf(before, 2 * size);
        besides = Arrays.copyOf(besides, 2 * size);
      }
      places[size] = 3 * place + kind;
      before[size] = number;
      besides[size++] = beside;
    }

    void all() {
      while (size > 0) {
        size--;
        int place = places[size] / 3;
        if (places[size] % 3 == VALUE) {
          value[place] = before[size];
          supporter[place] = besides[size];
        } else if (places[size] % 3 == COUNT) {
          counted[place] = before[size];
        } else {
          sums[place] = before[size];
          open[place] = besides[size];
        }
      }
    }
  }
}
