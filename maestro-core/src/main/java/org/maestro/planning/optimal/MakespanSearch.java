package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.PriorityQueue;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.maestro.planning.api.PlanTime;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.StepOrder;
import org.maestro.planning.problem.Successors;

/**
 * A* for the plan that is over first; among those of equal length the cheapest. A node is a state
 * with the times at which its parts were last written and read and its members are free. Steps are
 * added in the order of their beginnings, which loses no schedule. As in execution, steps that no
 * sensing needs begin when all sensing is done. The bound is the time at which the relaxed goal
 * could be reached from these times. Of two nodes of the same state the one that is no better in
 * any time nor in cost is dropped.
 */
public final class MakespanSearch {
  private static final double GRAIN = 1e6;
  private static final double NOTHING_SENSED = -1;

  /** The result of the search: a plan, exhaustion, or a bound on the makespan. */
  public sealed interface Outcome {
    record Found(List<Operator> operators) implements Outcome {}

    record Exhausted() implements Outcome {}

    /** Nothing shorter than this many seconds exists. */
    record BoundReached(double atLeastSeconds) implements Outcome {}
  }

  /** The part of a search node that decides which steps may follow and when. */
  private record Situation(State state, boolean sensingIsOver, Set<Operator> unserved) {}

  /**
   * Times in seconds.
   *
   * @param began the latest beginning of a step: no later one begins before
   * @param end of the last step to end
   * @param sensed the end of all sensing so far
   * @param assigned for each part of the state when it was last set
   * @param added when it was last added to
   * @param read when it was last read
   * @param free for each member when it is
   */
  private record Times(
      double began,
      double end,
      double sensed,
      double[] assigned,
      double[] added,
      double[] read,
      double[] free) {

    boolean isNoLaterThan(Times other) {
      return end <= other.end
          && Math.max(sensed, began) <= Math.max(other.sensed, other.began)
          && isNoLater(assigned, other.assigned, other)
          && isNoLater(added, other.added, other)
          && isNoLater(read, other.read, other)
          && isNoLater(free, other.free, other);
    }

    private boolean isNoLater(double[] mine, double[] others, Times other) {
      for (int i = 0; i < mine.length; i++) {
        if (Math.max(mine[i], began) > Math.max(others[i], other.began)) {
          return false;
        }
      }
      return began <= other.began || mine.length == 0;
    }
  }

  private record Node(
      Situation situation,
      Times times,
      double cost,
      int depth,
      @Nullable Node parent,
      int operator,
      long finish,
      long total,
      long sequence)
      implements Comparable<Node> {
    @Override
    public int compareTo(Node other) {
      int byFinish = Long.compare(finish, other.finish);
      int byTotal = byFinish != 0 ? byFinish : Long.compare(total, other.total);
      int byDepth = byTotal != 0 ? byTotal : Integer.compare(other.depth, depth);
      return byDepth != 0 ? byDepth : Long.compare(sequence, other.sequence);
    }

    boolean isAsGoodAs(Node other) {
      return cost <= other.cost + 1e-9 && times.isNoLaterThan(other.times);
    }
  }

  private final GroundProblem problem;
  private final List<Operator> operators;
  private final RelaxedProblem relaxed;
  private final LandmarkCut costs;
  private final double mostSeconds;
  private final int mostNodes;
  private final Map<Object, Integer> places = new HashMap<>();
  private final int[] member;
  private final int[][] assigns;
  private final int[][] adds;
  private final int[][] reads;
  private final boolean[] senses;
  private final boolean[][] conflicts;
  private final double leastSetting;
  private final Map<Situation, List<Node>> kept = new HashMap<>();
  private final Map<State, Double> leastCosts = new HashMap<>();
  private final PriorityQueue<Node> queue = new PriorityQueue<>();
  private long sequence;
  private int size;

  /**
   * @param mostSeconds a plan of that length is known
   * @param mostNodes beyond it the search is broken off
   */
  public MakespanSearch(GroundProblem problem, double mostSeconds, int mostNodes) {
    this.problem = problem;
    this.operators = problem.operators();
    this.relaxed = new RelaxedProblem(problem);
    this.costs = new LandmarkCut(relaxed);
    this.mostSeconds = mostSeconds;
    this.mostNodes = mostNodes;
    int n = operators.size();
    this.member = new int[n];
    this.assigns = new int[n][];
    this.adds = new int[n][];
    this.reads = new int[n][];
    this.senses = new boolean[n];
    this.conflicts = new boolean[n][n];
    Map<String, Integer> members = new LinkedHashMap<>();
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < n; i++) {
      Operator operator = operators.get(i);
      member[i] = members.computeIfAbsent(operator.feature().member(), m -> members.size());
      assigns[i] = placesOf(StepOrder.assigned(operator));
      adds[i] = placesOf(StepOrder.added(operator));
      reads[i] = placesOf(StepOrder.reads(operator));
      senses[i] = PlanTime.senses(operator.feature().type().effect());
      if (relaxed.settings().settingOf(operator).isPresent()) {
        least = Math.min(least, leastSeconds(operator));
      }
      for (int j = 0; j <= i; j++) {
        conflicts[i][j] = StepOrder.conflict(operators.get(j), operator);
        conflicts[j][i] = conflicts[i][j];
      }
    }
    this.leastSetting = Double.isFinite(least) ? least : 0;
  }

  private int[] placesOf(Set<Object> targets) {
    return targets.stream()
        .mapToInt(target -> places.computeIfAbsent(target, absent -> places.size()))
        .toArray();
  }

  /** The least that a step takes in any state. */
  private double leastSeconds(Operator operator) {
    return operator.price().seconds().isConstant()
        ? operator.price().seconds(problem.initial().numbers())
        : 0;
  }

  public Outcome run() {
    for (boolean sensingIsOver : new boolean[] {true, false}) {
      Situation situation = new Situation(problem.initial(), sensingIsOver, Set.of());
      Times times =
          new Times(
              0,
              0,
              NOTHING_SENSED,
              new double[places.size()],
              new double[places.size()],
              new double[places.size()],
              new double[operators.size()]);
      add(situation, times, 0, 0, null, -1);
    }
    while (!queue.isEmpty()) {
      Node node = queue.remove();
      if (!isKept(node)) {
        continue;
      }
      if (node.situation().unserved().isEmpty()
          && problem.goal().condition().holds(node.situation().state())) {
        return new Outcome.Found(operatorsTo(node));
      }
      if (size > mostNodes) {
        return new Outcome.BoundReached(node.finish() / GRAIN);
      }
      expand(node);
    }
    return new Outcome.Exhausted();
  }

  /** Whether none was found since that is as good. */
  private boolean isKept(Node node) {
    return Objects.requireNonNull(kept.get(node.situation())).stream()
        .anyMatch(other -> other.sequence() == node.sequence());
  }

  private void expand(Node node) {
    Situation situation = node.situation();
    if (!situation.sensingIsOver()
        && situation.unserved().isEmpty()
        && node.times().sensed() > NOTHING_SENSED) {
      Times times = node.times();
      double began = Math.max(times.began(), times.sensed());
      add(
          new Situation(situation.state(), true, Set.of()),
          new Times(
              began,
              times.end(),
              times.sensed(),
              times.assigned(),
              times.added(),
              times.read(),
              times.free()),
          node.cost(),
          node.depth(),
          node.parent(),
          node.operator());
    }
    for (int i = 0; i < operators.size(); i++) {
      Operator operator = operators.get(i);
      if (!(senses[i] && situation.sensingIsOver())
          && Successors.isApplicable(operator, situation.state())) {
        State after = Successors.after(operator, situation.state());
        double start = start(i, node.times());
        if (!after.equals(situation.state()) && start >= node.times().began()) {
          append(node, i, after, start);
        }
      }
    }
  }

  private void append(Node node, int operator, State after, double start) {
    Situation before = node.situation();
    State state = before.state();
    Operator step = operators.get(operator);
    double end = start + step.price().seconds(state.numbers());
    Set<Operator> unserved = before.unserved();
    if (!before.sensingIsOver()) {
      unserved = new HashSet<>(unserved);
      if (senses[operator]) {
        unserved.removeAll(neededBy(operator, node));
      } else {
        unserved.add(step);
      }
    }
    Times times = node.times();
    double[] assigned = times.assigned().clone();
    double[] added = times.added().clone();
    double[] read = times.read().clone();
    double[] free = times.free().clone();
    raise(assigned, assigns[operator], end);
    raise(added, adds[operator], end);
    raise(read, reads[operator], end);
    free[member[operator]] = end;
    add(
        new Situation(after, before.sensingIsOver(), unserved),
        new Times(
            start,
            Math.max(times.end(), end),
            senses[operator] ? Math.max(times.sensed(), end) : times.sensed(),
            assigned,
            added,
            read,
            free),
        node.cost() + step.price().cost(state.numbers()),
        node.depth() + 1,
        node,
        operator);
  }

  private static void raise(double[] times, int[] places, double time) {
    for (int place : places) {
      times[place] = Math.max(times[place], time);
    }
  }

  private double start(int operator, Times times) {
    double start = Math.max(times.began(), times.free()[member[operator]]);
    for (int place : assigns[operator]) {
      start = Math.max(start, Math.max(times.assigned()[place], times.added()[place]));
      start = Math.max(start, times.read()[place]);
    }
    for (int place : adds[operator]) {
      start = Math.max(start, Math.max(times.assigned()[place], times.read()[place]));
    }
    for (int place : reads[operator]) {
      start = Math.max(start, Math.max(times.assigned()[place], times.added()[place]));
    }
    return start;
  }

  /** The steps so far that the operator has to wait for, directly or not. */
  private Set<Operator> neededBy(int operator, Node last) {
    List<Integer> needed = new ArrayList<>(List.of(operator));
    Set<Operator> found = new HashSet<>();
    for (Node node = last; node != null && node.operator() >= 0; node = node.parent()) {
      int earlier = node.operator();
      if (needed.stream().anyMatch(later -> conflicts[later][earlier])) {
        needed.add(earlier);
        found.add(operators.get(earlier));
      }
    }
    return found;
  }

  private void add(
      Situation situation,
      Times times,
      double cost,
      int depth,
      @Nullable Node parent,
      int operator) {
    double finish = Math.max(times.end(), earliest(situation.state(), times));
    if (finish > mostSeconds + 1e-9) {
      return;
    }
    double least = leastCosts.computeIfAbsent(situation.state(), state -> costs.estimate(state));
    if (Double.isInfinite(least)) {
      return;
    }
    Node node =
        new Node(
            situation,
            times,
            cost,
            depth,
            parent,
            operator,
            Math.round(finish * GRAIN),
            Math.round((cost + least) * GRAIN),
            sequence++);
    List<Node> others = kept.computeIfAbsent(situation, absent -> new ArrayList<>());
    if (others.stream().noneMatch(other -> other.isAsGoodAs(node))) {
      size -= others.size();
      others.removeIf(node::isAsGoodAs);
      others.add(node);
      size += others.size();
      queue.add(node);
    }
  }

  /** When the goal could hold if nothing were ever undone and members did all at once. */
  private double earliest(State state, Times times) {
    boolean[] truths = relaxed.truths(state);
    double[] prices = relaxed.costs(state);
    double[] value = new double[truths.length];
    Arrays.fill(value, Double.POSITIVE_INFINITY);
    for (int i = 0; i < truths.length; i++) {
      if (truths[i]) {
        value[i] = since(relaxed.leaf(i), times);
      }
    }
    boolean changed = true;
    while (changed) {
      changed = false;
      for (RelaxedProblem.Action action : relaxed.actions()) {
        double reached = 0;
        for (int needed : action.preconditions()) {
          reached = Math.max(reached, value[needed]);
        }
        int payer = action.payer();
        if (payer >= operators.size()) {
          reached =
              Double.isInfinite(prices[payer])
                  ? Double.POSITIVE_INFINITY
                  : prices[payer] > 0 ? Math.max(reached, times.began() + leastSetting) : reached;
        } else if (payer >= 0) {
          reached =
              Math.max(reached, Math.max(times.began(), times.free()[member[payer]]))
                  + leastSeconds(operators.get(payer));
        }
        for (int added : action.additions()) {
          if (reached < value[added]) {
            value[added] = reached;
            changed = true;
          }
        }
      }
    }
    return value[relaxed.goal()];
  }

  /** Since when a condition that holds may be counted on: zero is always right. */
  private double since(Condition leaf, Times times) {
    Integer place =
        leaf instanceof Condition.Literal literal ? places.get(literal.variable()) : null;
    return place == null ? 0 : times.assigned()[place];
  }

  private List<Operator> operatorsTo(Node last) {
    List<Operator> taken = new ArrayList<>();
    for (Node node = last; node != null && node.operator() >= 0; node = node.parent()) {
      taken.add(operators.get(node.operator()));
    }
    Collections.reverse(taken);
    return taken;
  }
}
