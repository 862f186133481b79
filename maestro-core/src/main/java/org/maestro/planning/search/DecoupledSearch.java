package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.Consumer;
import org.maestro.planning.ground.GroundingBudget;

/**
 * A* over the centre of a task, with the prices of each leaf's states beside it (star-topology
 * decoupled search, Gnad and Hoffmann 2018): where robots are and what lamps are on is never
 * enumerated together. Without leaves it is A* over all states. Of states with the same centre, one
 * whose leaves' prices make up for no more than the other costs more stands for the other. The
 * bounds are landmark cuts from centre and prices. Not thread-safe.
 */
final class DecoupledSearch {
  /** The reason why a search ended. */
  enum End {
    /** Nothing is cheaper than the bound or the best plan found: proven. */
    EXHAUSTED,
    /** The memory, or the number of states, that was allowed did not suffice. */
    OUT_OF_MEMORY
  }

  /**
   * At most so many sources of a leaf stand alone in an estimate; the others are taken together.
   */
  private static final int MOST_SOURCES = 48;

  /** So many states with the same centre are compared, the newest first. */
  private static final int COMPARED = 400;

  private static final long UNKNOWN = -1;

  private final SearchTask task;
  private final CentreOperators operators;
  private final Leaf[] leaves;
  private final LandmarkCuts cuts;
  private final GroundingBudget patience;
  private final long memory;
  private final int mostStates;
  private final int weight;
  private final Consumer<List<Integer>> found;
  private final StateTable centres;
  private final List<int[]> opens = new ArrayList<>();
  private int[][] sameCentre = new int[256][];
  private int[] sameCentreCount = new int[256];
  private final StateTable table;
  private long[] cost = new long[1024];
  private long[] estimate = new long[1024];
  private int[] parent = new int[1024];
  private int[] operatorTo = new int[1024];
  private boolean[] closed = new boolean[1024];
  private final IntHeap queue = new IntHeap();
  private long below;
  private long lowerBound;

  /**
   * @param below plans that cost this much or more are not looked for
   * @param weight of the estimate against the cost so far; with 1 the first plan is the cheapest,
   *     with more there is one sooner
   * @param memory how many bytes may be used, about
   * @param mostStates with more the search ends too, as if memory was used up
   * @param found is told each better plan
   */
  DecoupledSearch(
      SearchTask task,
      List<Leaf> leaves,
      long below,
      int weight,
      long memory,
      int mostStates,
      GroundingBudget patience,
      Consumer<List<Integer>> found) {
    this.task = task;
    this.weight = weight;
    this.leaves = leaves.toArray(Leaf[]::new);
    this.operators = new CentreOperators(task, this.leaves, patience);
    this.below = below;
    this.memory = memory;
    this.mostStates = mostStates;
    this.patience = patience;
    this.found = found;
    this.cuts = new LandmarkCuts(task, task.cost, patience);
    centres = new StateTable(task.initial.length);
    table = new StateTable(1 + (this.leaves.length + 1) / 2);
  }

  /** No plan costs less, as far as is known. */
  long lowerBound() {
    return Math.min(below, lowerBound);
  }

  int states() {
    return table.size();
  }

  /**
   * Searches until the cheapest plan is proven.
   *
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  End run() {
    int centre = centre(operators.projection(task.initial));
    int[] prices = new int[leaves.length];
    for (int leaf = 0; leaf < leaves.length; leaf++) {
      prices[leaf] = leaves[leaf].first(opens.get(centre)[leaf]).prices();
    }
    reach(centre, prices, 0, -1, -1, 0, 0);
    while (!queue.isEmpty()) {
      long total = queue.leastKey();
      int node = queue.removeLeast();
      if (closed[node]) {
        continue;
      }
      if (weight == 1) {
        lowerBound = Math.max(lowerBound, total);
        if (total >= below) {
          lowerBound = below;
          return End.EXHAUSTED;
        }
      } else if (cost[node] + Math.max(0, estimate[node]) >= below) {
        continue;
      }
      if (estimate[node] == UNKNOWN) {
        evaluate(node, total);
        continue;
      }
      if (table.size() > mostStates || isMemoryUsedUp()) {
        return End.OUT_OF_MEMORY;
      }
      closed[node] = true;
      expand(node, total);
    }
    lowerBound = below;
    return End.EXHAUSTED;
  }

  /** What leaves remember for speed goes first. */
  private boolean isMemoryUsedUp() {
    if (bytes() <= memory) {
      return false;
    }
    for (Leaf leaf : leaves) {
      leaf.forget();
    }
    return bytes() > memory / 4 * 3;
  }

  private long bytes() {
    long bytes = table.bytes() + centres.bytes() + queue.bytes();
    bytes += 60L * table.size() + (24L + 4L * leaves.length) * centres.size();
    for (Leaf leaf : leaves) {
      bytes += leaf.bytes();
    }
    return bytes;
  }

  private void evaluate(int node, long total) {
    patience.check();
    long[] key = table.state(node);
    int centre = (int) key[0];
    cuts.begin();
    operators.forEachFact(centres.state(centre), cuts::addFact);
    for (int leaf = 0; leaf < leaves.length; leaf++) {
      addSources(leaves[leaf], prices(key, leaf), opens.get(centre)[leaf]);
    }
    // What costs as much as the best plan is dropped: by how much it costs more does not matter.
    estimate[node] = cuts.estimate(below - cost[node]);
    if (estimate[node] >= LandmarkCuts.INFINITE) {
      closed[node] = true;
      return;
    }
    enqueue(node, total(total, cost[node], estimate[node]), estimate[node]);
  }

  /** A total never falls along a way, when it is to be a lower bound. */
  private long total(long before, long paid, long left) {
    return weight == 1 ? Math.max(before, paid + left) : paid + weight * left;
  }

  private void addSources(Leaf leaf, int prices, int open) {
    int[] sources = leaf.sources(prices, open);
    long restPrice = Leaf.INFINITE;
    List<Integer> rest = new ArrayList<>();
    for (int i = 0; i < sources.length; i++) {
      long price = leaf.priceOf(prices, sources[i]);
      if (price == 0) {
        for (int fact : leaf.facts(sources[i])) {
          cuts.addFact(fact);
        }
      } else if (i < MOST_SOURCES) {
        cuts.addSource(leaf.facts(sources[i]), price);
      } else {
        restPrice = Math.min(restPrice, price);
        Arrays.stream(leaf.facts(sources[i])).forEach(rest::add);
      }
    }
    if (!rest.isEmpty()) {
      cuts.addSource(rest.stream().mapToInt(i -> i).distinct().toArray(), restPrice);
    }
  }

  private void enqueue(int node, long total, long tie) {
    if (weight > 1 || total < below) {
      queue.add(total, (int) Math.min(Integer.MAX_VALUE, tie), node);
    }
  }

  private void expand(int node, long total) {
    long[] key = table.state(node);
    int centre = (int) key[0];
    int[] prices = new int[leaves.length];
    for (int i = 0; i < operators.size(); i++) {
      if (!operators.isApplicable(centres.state(centre), i)) {
        continue;
      }
      patience.refuseIfOver();
      long reached = cost[node] + operators.cost(i);
      int[] asked = operators.asked(i);
      int[] conditions = operators.conditions(i);
      for (int k = 0; k < asked.length && reached < below; k++) {
        reached += leaves[asked[k]].price(prices(key, asked[k]), conditions[k]);
      }
      if (reached >= below) {
        continue;
      }
      int next = centre(operators.after(centres.state(centre), i));
      for (int leaf = 0; leaf < leaves.length; leaf++) {
        prices[leaf] = prices(key, leaf);
      }
      for (int k = 0; k < asked.length; k++) {
        int leaf = asked[k];
        prices[leaf] =
            leaves[leaf].step(prices[leaf], conditions[k], opens.get(next)[leaf]).prices();
      }
      for (int leaf : operators.unlocked(i)) {
        if (Arrays.binarySearch(asked, leaf) < 0) {
          prices[leaf] =
              leaves[leaf].step(prices[leaf], Leaf.ANYTHING, opens.get(next)[leaf]).prices();
        }
      }
      long hoped = Math.max(0, estimate[node] - (reached - cost[node]));
      reach(next, prices, reached, node, i, total, hoped);
    }
  }

  private void reach(
      int centre, int[] prices, long reached, int from, int operator, long total, long hoped) {
    long[] key = new long[1 + (leaves.length + 1) / 2];
    key[0] = centre;
    for (int leaf = 0; leaf < leaves.length; leaf++) {
      key[1 + leaf / 2] |= (long) prices[leaf] << (leaf % 2 == 0 ? 0 : 32);
    }
    if (isDominated(centre, prices, reached)) {
      return;
    }
    int before = table.size();
    int node = table.number(key);
    if (node == before) {
      grow(node);
      estimate[node] = UNKNOWN;
      remember(centre, node);
    } else if (reached >= cost[node] || estimate[node] >= LandmarkCuts.INFINITE) {
      return;
    }
    cost[node] = reached;
    parent[node] = from;
    operatorTo[node] = operator;
    closed[node] = false;
    lookForGoal(node);
    if (estimate[node] == UNKNOWN) {
      enqueue(node, total(total, reached, weight == 1 ? 0 : hoped), hoped);
    } else {
      enqueue(node, total(total, reached, estimate[node]), estimate[node]);
    }
  }

  /**
   * Whether a state with the same centre makes this one superfluous; those that this one does go.
   */
  private boolean isDominated(int centre, int[] prices, long reached) {
    int count = centre < sameCentreCount.length ? sameCentreCount[centre] : 0;
    int[] others = count == 0 ? new int[0] : sameCentre[centre];
    for (int i = count - 1; i >= Math.max(0, count - COMPARED); i--) {
      patience.check();
      int other = others[i];
      long[] key = table.state(other);
      long price = cost[other];
      for (int leaf = 0; leaf < prices.length && price <= reached; leaf++) {
        price += leaves[leaf].excess(prices(key, leaf), prices[leaf]);
      }
      if (price <= reached) {
        return true;
      }
      if (!closed[other] && cost[other] >= reached) {
        price = reached;
        for (int leaf = 0; leaf < prices.length && price <= cost[other]; leaf++) {
          price += leaves[leaf].excess(prices[leaf], prices(key, leaf));
        }
        closed[other] = price <= cost[other];
      }
    }
    return false;
  }

  private void lookForGoal(int node) {
    long[] key = table.state(node);
    if (!operators.isGoal(centres.state((int) key[0]))) {
      return;
    }
    long whole = cost[node];
    for (int leaf = 0; leaf < leaves.length && whole < below; leaf++) {
      whole += leaves[leaf].price(prices(key, leaf), operators.goalConditions()[leaf]);
    }
    if (whole < below) {
      below = whole;
      found.accept(plan(node));
    }
  }

  /** The operators to a node, with the leaves' own between those of the centre. */
  private List<Integer> plan(int last) {
    List<Integer> nodes = new ArrayList<>();
    for (int node = last; node >= 0; node = parent[node]) {
      nodes.add(node);
    }
    Collections.reverse(nodes);
    List<List<Integer>> between = new ArrayList<>();
    nodes.forEach(node -> between.add(new ArrayList<>()));
    for (int leaf = 0; leaf < leaves.length; leaf++) {
      int state =
          leaves[leaf].cheapest(prices(table.state(last), leaf), operators.goalConditions()[leaf]);
      for (int k = nodes.size() - 1; k >= 0; k--) {
        int node = nodes.get(k);
        int open = opens.get((int) table.state(node)[0])[leaf];
        int before = k == 0 ? -1 : prices(table.state(nodes.get(k - 1)), leaf);
        int condition = k == 0 ? Leaf.ANYTHING : operators.condition(operatorTo[node], leaf);
        List<Integer> way = new ArrayList<>();
        state = leaves[leaf].way(before, condition, open, state, way);
        between.get(k).addAll(way);
      }
    }
    List<Integer> plan = new ArrayList<>(between.get(0));
    for (int k = 1; k < nodes.size(); k++) {
      plan.add(operators.operator(operatorTo[nodes.get(k)]));
      plan.addAll(between.get(k));
    }
    return plan;
  }

  private static int prices(long[] key, int leaf) {
    return (int) (key[1 + leaf / 2] >>> (leaf % 2 == 0 ? 0 : 32));
  }

  private int centre(long[] state) {
    int number = centres.number(state);
    if (number == opens.size()) {
      int[] open = new int[leaves.length];
      for (int leaf = 0; leaf < leaves.length; leaf++) {
        open[leaf] = leaves[leaf].open(state);
      }
      opens.add(open);
    }
    return number;
  }

  private void remember(int centre, int node) {
    if (centre >= sameCentre.length) {
      sameCentre = Arrays.copyOf(sameCentre, 2 * centre);
      sameCentreCount = Arrays.copyOf(sameCentreCount, 2 * centre);
    }
    if (sameCentre[centre] == null) {
      sameCentre[centre] = new int[2];
    } else if (sameCentre[centre].length == sameCentreCount[centre]) {
      sameCentre[centre] = Arrays.copyOf(sameCentre[centre], 2 * sameCentreCount[centre]);
    }
    sameCentre[centre][sameCentreCount[centre]++] = node;
  }

  private void grow(int node) {
    if (node >= cost.length) {
      int size = 2 * node;
      cost = Arrays.copyOf(cost, size);
      estimate = Arrays.copyOf(estimate, size);
      parent = Arrays.copyOf(parent, size);
      operatorTo = Arrays.copyOf(operatorTo, size);
      closed = Arrays.copyOf(closed, size);
    }
  }
}
