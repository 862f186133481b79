package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundTask.Bound;
import org.maestro.planning.ground.GroundingBudget;

/**
 * Replaces the operators that add to a sum, as lamps and shutters do, by one that settles it for
 * each interval that is asked of it, at the price of the cheapest choice of them. That is exact if
 * each of them looks at nothing but itself and of any two intervals one lies in the other: then a
 * plan may as well settle the narrowest first. Sums that are otherwise stay as they are.
 */
final class SettledTask {
  private static final int MOST_POSITIONS = 16;

  /** The schema of operators that settle a sum; their argument is a number of their meaning. */
  private static final int SETTLING = -1;

  private final List<List<GroundOperator>> meanings = new ArrayList<>();
  private final GroundingBudget patience;
  private GroundTask task;

  /** A position of one lamp: what it adds, what it costs, and how it is reached. */
  private record Position(BitSet facts, long gain, long cost, List<GroundOperator> way) {}

  private record Interval(long least, long most) {
    private boolean contains(Interval other) {
      return least <= other.least && most >= other.most;
    }

    private Interval and(Bound bound) {
      return new Interval(Math.max(least, bound.least()), Math.min(most, bound.most()));
    }
  }

  /**
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  SettledTask(GroundTask origin, GroundingBudget patience) {
    this.patience = patience;
    task = origin.sums().length == 0 ? origin : Reduction.reduced(origin, patience);
    for (int sum = 0; sum < origin.sums().length; sum++) {
      settle(sum);
    }
  }

  /** The task with sums settled where that is exact. */
  GroundTask task() {
    return task;
  }

  /** The operators of the original task that some of the settled one stand for. */
  List<GroundOperator> meant(List<GroundOperator> plan) {
    return plan.stream()
        .flatMap(
            operator ->
                operator.schema() == SETTLING
                    ? meanings.get(operator.arguments()[0]).stream()
                    : Stream.of(operator))
        .toList();
  }

  private void settle(int sum) {
    List<GroundOperator> movers = new ArrayList<>();
    List<GroundOperator> others = new ArrayList<>();
    for (GroundOperator operator : task.operators()) {
      boolean moves = Arrays.binarySearch(operator.changedSums(), sum) >= 0;
      (moves ? movers : others).add(operator);
    }
    Optional<List<List<Position>>> lamps = lamps(movers, others);
    if (lamps.isEmpty()) {
      return;
    }
    List<Interval> intervals = intervals(sum, others);
    for (int i = 1; i < intervals.size(); i++) {
      if (!intervals.get(i).contains(intervals.get(i - 1))) {
        return;
      }
    }
    List<List<TwoSidedKnapsack.Option>> options =
        lamps.get().stream()
            .map(
                lamp ->
                    lamp.stream()
                        .map(p -> new TwoSidedKnapsack.Option(p.gain(), p.cost()))
                        .toList())
            .toList();
    if (TwoSidedKnapsack.isSmallEnough(options)) {
      rewrite(sum, others, intervals, lamps.get(), options);
    }
  }

  /** What others and the goal ask of a sum, the narrowest first. */
  private List<Interval> intervals(int sum, List<GroundOperator> others) {
    List<Interval> all = new ArrayList<>();
    others.forEach(operator -> interval(sum, operator.bounds()).ifPresent(all::add));
    interval(sum, task.goalBounds()).ifPresent(all::add);
    return all.stream()
        .distinct()
        .sorted(
            Comparator.comparingLong(Interval::least).reversed().thenComparingLong(Interval::most))
        .toList();
  }

  private Optional<Interval> interval(int sum, int[] bounds) {
    Interval interval = new Interval(Long.MIN_VALUE, Long.MAX_VALUE);
    boolean asked = false;
    for (int b : bounds) {
      if (task.bounds().get(b).sum() == sum) {
        interval = interval.and(task.bounds().get(b));
        asked = true;
      }
    }
    return asked ? Optional.of(interval) : Optional.empty();
  }

  /** The positions of everything that adds to the sum; empty when it looks at more than itself. */
  private Optional<List<List<Position>>> lamps(
      List<GroundOperator> movers, List<GroundOperator> others) {
    BitSet own = new BitSet();
    for (GroundOperator mover : movers) {
      if (mover.changedSums().length != 1 || mover.bounds().length > 0) {
        return Optional.empty();
      }
      Arrays.stream(mover.needed()).forEach(own::set);
      Arrays.stream(mover.added()).forEach(own::set);
    }
    if (Arrays.stream(task.goal()).anyMatch(own::get)) {
      return Optional.empty();
    }
    for (GroundOperator other : others) {
      if (touches(other.needed(), own)
          || touches(other.added(), own)
          || touches(other.deleted(), own)) {
        return Optional.empty();
      }
    }
    List<List<Position>> lamps = new ArrayList<>();
    for (List<GroundOperator> together : groups(movers)) {
      Optional<List<Position>> positions = positions(together, own);
      if (positions.isEmpty()) {
        return Optional.empty();
      }
      lamps.add(positions.get());
    }
    return Optional.of(lamps);
  }

  private static boolean touches(int[] facts, BitSet set) {
    return Arrays.stream(facts).anyMatch(set::get);
  }

  /** Operators that share facts of their own, in the order of the first. */
  private static List<List<GroundOperator>> groups(List<GroundOperator> movers) {
    Map<Integer, List<GroundOperator>> groupOf = new HashMap<>();
    Set<List<GroundOperator>> groups = Collections.newSetFromMap(new IdentityHashMap<>());
    List<List<GroundOperator>> inOrder = new ArrayList<>();
    for (GroundOperator mover : movers) {
      List<GroundOperator> group = new ArrayList<>();
      inOrder.add(group);
      groups.add(group);
      group.add(mover);
      TreeSet<Integer> facts = new TreeSet<>();
      Arrays.stream(mover.needed()).forEach(facts::add);
      Arrays.stream(mover.added()).forEach(facts::add);
      for (int fact : facts) {
        List<GroundOperator> known = groupOf.get(fact);
        if (known != null && known != group) {
          group.addAll(known);
          groups.remove(known);
          groupOf.replaceAll((f, g) -> g == known ? group : g);
        }
        groupOf.put(fact, group);
      }
    }
    return inOrder.stream().filter(groups::contains).toList();
  }

  private Optional<List<Position>> positions(List<GroundOperator> together, BitSet own) {
    BitSet initial = new BitSet();
    Arrays.stream(task.initial()).filter(own::get).forEach(initial::set);
    BitSet concerned = new BitSet();
    for (GroundOperator operator : together) {
      Arrays.stream(operator.needed()).forEach(concerned::set);
      Arrays.stream(operator.added()).forEach(concerned::set);
    }
    initial.and(concerned);
    record Place(BitSet facts, long gain) {}
    Map<Place, Position> best = new LinkedHashMap<>();
    List<Position> open = new ArrayList<>();
    Position first = new Position(initial, 0, 0, List.of());
    best.put(new Place(initial, 0), first);
    open.add(first);
    while (!open.isEmpty()) {
      patience.check();
      Position from = open.remove(0);
      for (GroundOperator operator : together) {
        if (!Arrays.stream(operator.needed()).allMatch(from.facts()::get)) {
          continue;
        }
        BitSet facts = (BitSet) from.facts().clone();
        Arrays.stream(operator.deleted()).filter(own::get).forEach(facts::clear);
        Arrays.stream(operator.added()).forEach(facts::set);
        List<GroundOperator> way = new ArrayList<>(from.way());
        way.add(operator);
        Position to =
            new Position(
                facts, from.gain() + operator.changes()[0], from.cost() + operator.cost(), way);
        Position known = best.get(new Place(facts, to.gain()));
        if (known == null || to.cost() < known.cost()) {
          best.put(new Place(facts, to.gain()), to);
          open.add(to);
        }
      }
      if (best.size() > MOST_POSITIONS) {
        return Optional.empty();
      }
    }
    return Optional.of(List.copyOf(best.values()));
  }

  private void rewrite(
      int sum,
      List<GroundOperator> others,
      List<Interval> intervals,
      List<List<Position>> lamps,
      List<List<TwoSidedKnapsack.Option>> options) {
    int firstFact = task.facts();
    long atFirst = task.sums()[sum];
    TreeSet<Integer> initial = new TreeSet<>();
    Arrays.stream(task.initial()).forEach(initial::add);
    initial.add(firstFact + intervals.size());
    List<GroundOperator> operators = new ArrayList<>();
    for (GroundOperator other : others) {
      operators.add(
          new GroundOperator(
              other.schema(),
              other.arguments(),
              withInterval(sum, other.needed(), other.bounds(), intervals, firstFact),
              other.added(),
              other.deleted(),
              withoutSum(sum, other.bounds()),
              other.changedSums(),
              other.changes(),
              other.cost()));
    }
    for (int i = 0; i < intervals.size(); i++) {
      Interval interval = intervals.get(i);
      if (interval.least() <= atFirst && atFirst <= interval.most()) {
        initial.add(firstFact + i);
      }
      long least = interval.least() == Long.MIN_VALUE ? Long.MIN_VALUE : interval.least() - atFirst;
      long most = interval.most() == Long.MAX_VALUE ? Long.MAX_VALUE : interval.most() - atFirst;
      int narrowest = i;
      TwoSidedKnapsack.solve(options, least, most, patience)
          .ifPresent(
              choice ->
                  operators.add(
                      settling(
                          choice, lamps, firstFact + narrowest, firstFact + intervals.size())));
    }
    task =
        new GroundTask(
            firstFact + intervals.size() + 1,
            task.sums(),
            task.bounds(),
            operators,
            initial.stream().mapToInt(fact -> fact).toArray(),
            withInterval(sum, task.goal(), task.goalBounds(), intervals, firstFact),
            withoutSum(sum, task.goalBounds()),
            task.unit(),
            task.unreachable(),
            task.names());
  }

  /** A sum is settled once: the last fact says that it is not yet. */
  private GroundOperator settling(
      TwoSidedKnapsack.Choice choice, List<List<Position>> lamps, int from, int unsettled) {
    List<GroundOperator> meaning = new ArrayList<>();
    TreeSet<Integer> deleted = new TreeSet<>(List.of(unsettled));
    for (int lamp = 0; lamp < lamps.size(); lamp++) {
      for (GroundOperator operator : lamps.get(lamp).get(choice.options()[lamp]).way()) {
        meaning.add(operator);
        Arrays.stream(operator.deleted()).forEach(deleted::add);
      }
    }
    int[] none = {};
    int[] added = new int[unsettled - from];
    Arrays.setAll(added, i -> from + i);
    GroundOperator operator =
        new GroundOperator(
            SETTLING,
            new int[] {meanings.size()},
            new int[] {unsettled},
            added,
            deleted.stream().mapToInt(fact -> fact).toArray(),
            none,
            none,
            new long[0],
            choice.cost());
    meanings.add(List.copyOf(meaning));
    return operator;
  }

  private int[] withInterval(
      int sum, int[] needed, int[] bounds, List<Interval> intervals, int firstFact) {
    Optional<Interval> interval = interval(sum, bounds);
    if (interval.isEmpty()) {
      return needed;
    }
    int[] more = Arrays.copyOf(needed, needed.length + 1);
    more[needed.length] = firstFact + intervals.indexOf(interval.get());
    return more;
  }

  private int[] withoutSum(int sum, int[] bounds) {
    return Arrays.stream(bounds).filter(b -> task.bounds().get(b).sum() != sum).toArray();
  }
}
