package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * The prices of a component's states along a path of the centre (Gnad and Hoffmann 2018): what each
 * state costs at least, beyond the cheapest. Price lists are numbered, and what the centre does to
 * them is computed once.
 */
final class Leaf {
  static final long INFINITE = Long.MAX_VALUE / 4;

  /** No condition. */
  static final int ANYTHING = 0;

  /**
   * The successor of a price list, after something was done to it.
   *
   * @param prices its number
   * @param paid what the cheapest state costs more than before; infinite when no state is left
   */
  record Step(int prices, long paid) {
    private static final Step IMPOSSIBLE = new Step(-1, INFINITE);
  }

  private record Key(long[] prices) {
    @Override
    public boolean equals(Object other) {
      return other instanceof Key that && Arrays.equals(prices, that.prices);
    }

    @Override
    public int hashCode() {
      return Arrays.hashCode(prices);
    }
  }

  private record Change(int prices, int condition, int open) {}

  private record Pair(int from, int to) {}

  private record Condition(List<Integer> needed, List<Integer> bounds) {}

  final LeafSpace space;
  private final SearchTask task;
  private final int[] gates;
  private final Map<BitSet, Integer> opens = new HashMap<>();
  private final List<BitSet> openGates = new ArrayList<>();
  private final Map<Condition, Integer> conditions = new HashMap<>();
  private final List<BitSet> fulfilling = new ArrayList<>();
  private final Map<Key, Integer> numbers = new HashMap<>();
  private final List<long[]> lists = new ArrayList<>();
  private final Map<Change, int[]> sources = new HashMap<>();
  private final Map<Change, Step> steps = new HashMap<>();
  private final Map<Pair, Long> excesses = new HashMap<>();
  private final int[][] factsOf;
  private final IntHeap queue = new IntHeap();

  Leaf(SearchTask task, LeafSpace space) {
    this.task = task;
    this.space = space;
    gates = space.gates();
    factsOf = new int[space.size()][];
    BitSet all = new BitSet();
    all.set(0, space.size());
    conditions.put(new Condition(List.of(), List.of()), ANYTHING);
    fulfilling.add(all);
  }

  /** The number of what a condition asks of this component. */
  int condition(int[] needed, int[] bounds) {
    List<Integer> own = Arrays.stream(needed).filter(space::concerns).boxed().toList();
    List<Integer> ownBounds =
        Arrays.stream(bounds)
            .filter(b -> space.concernsSum(task.origin.bounds().get(b).sum()))
            .boxed()
            .toList();
    return conditions.computeIfAbsent(
        new Condition(own, ownBounds),
        condition -> {
          BitSet states = new BitSet();
          for (int state = 0; state < space.size(); state++) {
            if (space.fulfils(state, needed, bounds)) {
              states.set(state);
            }
          }
          fulfilling.add(states);
          return conditions.size();
        });
  }

  int[] gates() {
    return gates;
  }

  /** About how many bytes the price lists and what is remembered of them take. */
  long bytes() {
    return lists.size() * (8L * space.size() + 150)
        + 130L * (steps.size() + sources.size())
        + 120L * excesses.size();
  }

  /** Forgets what can be computed again. */
  void forget() {
    excesses.clear();
    sources.clear();
    steps.clear();
  }

  /** The number of the set of gates that are open in a state of the task. */
  int open(long[] centre) {
    BitSet open = new BitSet();
    for (int i = 0; i < gates.length; i++) {
      open.set(i, SearchTask.holds(centre, gates[i]));
    }
    return opens.computeIfAbsent(
        open,
        fresh -> {
          openGates.add(fresh);
          return opens.size();
        });
  }

  /** The prices at first. */
  Step first(int open) {
    long[] prices = new long[space.size()];
    Arrays.fill(prices, INFINITE);
    prices[0] = 0;
    close(prices, open);
    return new Step(number(prices), 0);
  }

  /** A step of the centre that needs a condition here, after which these gates are open. */
  Step step(int prices, int condition, int open) {
    return steps.computeIfAbsent(
        new Change(prices, condition, open),
        change -> {
          long[] kept = lists.get(prices).clone();
          BitSet allowed = fulfilling.get(condition);
          for (int state = 0; state < kept.length; state++) {
            kept[state] = allowed.get(state) ? kept[state] : INFINITE;
          }
          long least = Arrays.stream(kept).min().orElse(INFINITE);
          if (least >= INFINITE) {
            return Step.IMPOSSIBLE;
          }
          for (int state = 0; state < kept.length; state++) {
            kept[state] = kept[state] >= INFINITE ? INFINITE : kept[state] - least;
          }
          close(kept, open);
          return new Step(number(kept), least);
        });
  }

  /** What the cheapest state that fulfils a condition costs more. */
  long price(int prices, int condition) {
    long least = INFINITE;
    long[] list = lists.get(prices);
    BitSet allowed = fulfilling.get(condition);
    for (int state = allowed.nextSetBit(0); state >= 0; state = allowed.nextSetBit(state + 1)) {
      least = Math.min(least, list[state]);
    }
    return least;
  }

  private int number(long[] prices) {
    Integer known = numbers.get(new Key(prices));
    if (known != null) {
      return known;
    }
    numbers.put(new Key(prices), lists.size());
    lists.add(prices);
    return lists.size() - 1;
  }

  private boolean isOpen(int operator, BitSet open) {
    for (int gate : space.gates(operator)) {
      if (!open.get(Arrays.binarySearch(gates, gate))) {
        return false;
      }
    }
    return true;
  }

  /** Lets the prices spread over the operators whose gates are open. */
  private void close(long[] prices, int open) {
    BitSet gatesOpen = openGates.get(open);
    queue.clear();
    for (int state = 0; state < prices.length; state++) {
      if (prices[state] < INFINITE) {
        queue.add(prices[state], state);
      }
    }
    while (!queue.isEmpty()) {
      long now = queue.leastKey();
      int state = queue.removeLeast();
      if (now > prices[state]) {
        continue;
      }
      int[] targets = space.targets(state);
      int[] operators = space.steps(state);
      for (int i = 0; i < targets.length; i++) {
        long reached = now + task.cost[operators[i]];
        if (reached < prices[targets[i]] && isOpen(operators[i], gatesOpen)) {
          prices[targets[i]] = reached;
          queue.add(reached, targets[i]);
        }
      }
    }
  }

  /** The states whose prices do not follow from others' by an operator whose gates are open. */
  int[] sources(int prices, int open) {
    return sources.computeIfAbsent(new Change(prices, ANYTHING, open), change -> source(change));
  }

  private int[] source(Change change) {
    long[] list = lists.get(change.prices());
    BitSet gatesOpen = openGates.get(change.open());
    BitSet explained = new BitSet();
    for (int state = 0; state < list.length; state++) {
      int[] targets = space.targets(state);
      for (int i = 0; list[state] < INFINITE && i < targets.length; i++) {
        int operator = space.steps(state)[i];
        long cost = task.cost[operator];
        // Steps for nothing could explain each other in a circle.
        if (cost > 0 && list[targets[i]] == list[state] + cost && isOpen(operator, gatesOpen)) {
          explained.set(targets[i]);
        }
      }
    }
    return IntStream.range(0, list.length)
        .filter(state -> list[state] < INFINITE && !explained.get(state))
        .boxed()
        .sorted(Comparator.comparingLong(state -> list[state]))
        .mapToInt(state -> state)
        .toArray();
  }

  /** What a state of a list costs. */
  long priceOf(int prices, int state) {
    return lists.get(prices)[state];
  }

  /** The task's relaxed facts that hold in a state. */
  int[] facts(int state) {
    if (factsOf[state] == null) {
      factsOf[state] = space.relaxedFacts(state);
    }
    return factsOf[state];
  }

  /** How much more one list costs than another, at most, for any state. */
  long excess(int list, int other) {
    if (list == other) {
      return 0;
    }
    return excesses.computeIfAbsent(
        new Pair(list, other),
        pair -> {
          long[] here = lists.get(list);
          long[] there = lists.get(other);
          long most = 0;
          for (int state = 0; state < here.length; state++) {
            if (there[state] < INFINITE) {
              most =
                  Math.max(most, here[state] >= INFINITE ? INFINITE : here[state] - there[state]);
            }
          }
          return most;
        });
  }

  /** The cheapest state of a list that fulfils a condition. */
  int cheapest(int prices, int condition) {
    long[] list = lists.get(prices);
    BitSet allowed = fulfilling.get(condition);
    int best = -1;
    for (int state = allowed.nextSetBit(0); state >= 0; state = allowed.nextSetBit(state + 1)) {
      if (list[state] < INFINITE && (best < 0 || list[state] < list[best])) {
        best = state;
      }
    }
    return best;
  }

  /**
   * The way to a state since the centre's last step: its operators are added to the list.
   *
   * @param before the list before the centre's last step; below 0 for none
   * @param condition what that step needed here
   * @param open the gates since then
   * @return the state in which that step was done
   */
  int way(int before, int condition, int open, int state, List<Integer> operators) {
    long[] prices = new long[space.size()];
    Arrays.fill(prices, INFINITE);
    if (before < 0) {
      prices[0] = 0;
    } else {
      BitSet allowed = fulfilling.get(condition);
      for (int s = allowed.nextSetBit(0); s >= 0; s = allowed.nextSetBit(s + 1)) {
        prices[s] = lists.get(before)[s];
      }
    }
    int[] from = new int[prices.length];
    int[] by = new int[prices.length];
    Arrays.fill(from, -1);
    BitSet gatesOpen = openGates.get(open);
    queue.clear();
    for (int s = 0; s < prices.length; s++) {
      if (prices[s] < INFINITE) {
        queue.add(prices[s], s);
      }
    }
    while (!queue.isEmpty()) {
      long now = queue.leastKey();
      int s = queue.removeLeast();
      if (now > prices[s]) {
        continue;
      }
      for (int i = 0; i < space.targets(s).length; i++) {
        int to = space.targets(s)[i];
        int operator = space.steps(s)[i];
        if (now + task.cost[operator] < prices[to] && isOpen(operator, gatesOpen)) {
          prices[to] = now + task.cost[operator];
          from[to] = s;
          by[to] = operator;
          queue.add(prices[to], to);
        }
      }
    }
    List<Integer> reversed = new ArrayList<>();
    int at = state;
    while (from[at] >= 0) {
      reversed.add(by[at]);
      at = from[at];
    }
    Collections.reverse(reversed);
    operators.addAll(reversed);
    return at;
  }
}
