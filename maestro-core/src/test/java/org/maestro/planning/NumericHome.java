package org.maestro.planning;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;

/**
 * A home of stocks, levels and sums that a seed gives, and all the states that it can get into, by
 * trying everything. It shares nothing with the planner but the words in which it is told.
 */
final class NumericHome {
  private static final int FLAGS = 2;
  private static final int MOST_STATES = 3_000;

  /** All states that it can get into, or some of them when there are too many. */
  record Reached(Set<Situation> situations, boolean all) {
    double extreme(int quantity, boolean highest) {
      return situations.stream()
          .mapToDouble(s -> s.levels().get(quantity))
          .reduce((a, b) -> highest ? Math.max(a, b) : Math.min(a, b))
          .orElseThrow();
    }

    boolean any(Goal goal) {
      return situations.stream().anyMatch(goal::holds);
    }
  }

  record Situation(List<Double> levels, List<Boolean> flags) {}

  /** {@code level >= bound}, or {@code >}, {@code <=}, {@code <}. */
  record Comparison(int quantity, String relation, double bound) {
    boolean holds(Situation s) {
      double level = s.levels().get(quantity);
      return switch (relation) {
        case ">=" -> level >= bound - 1e-9;
        case ">" -> level > bound + 1e-9;
        case "<=" -> level <= bound + 1e-9;
        default -> level < bound - 1e-9;
      };
    }

    boolean isUpward() {
      return relation.startsWith(">");
    }

    @Override
    public String toString() {
      return "(%s (level q%d) %s)".formatted(relation, quantity, bound);
    }
  }

  record Goal(List<Comparison> comparisons, int flag) {
    boolean holds(Situation s) {
      return comparisons.stream().allMatch(c -> c.holds(s)) && (flag < 0 || s.flags().get(flag));
    }

    @Override
    public String toString() {
      StringBuilder text = new StringBuilder("(and");
      comparisons.forEach(c -> text.append(' ').append(c));
      return text.append(flag < 0 ? "" : " (open f" + flag + ")").append(")").toString();
    }
  }

  /** {@code constant + factor * level}; no level where the factor is 0. */
  private record Amount(double constant, double factor, int quantity) {
    double value(Situation s) {
      return constant + (factor == 0 ? 0 : factor * s.levels().get(quantity));
    }

    @Override
    public String toString() {
      return factor == 0
          ? String.valueOf(constant)
          : "(+ %s (* %s (level q%d)))".formatted(constant, factor, quantity);
    }
  }

  private record Change(String how, int quantity, Amount by, Comparison when) {
    @Override
    public String toString() {
      String change = "(%s (level q%d) %s)".formatted(how, quantity, by);
      return when == null ? change : "(when %s %s)".formatted(when, change);
    }
  }

  /**
   * @param flagNeeded and {@code flagPut}: -1 for none
   */
  private record Deed(
      String member, List<Comparison> needs, int flagNeeded, List<Change> changes, int flagPut) {
    boolean isPossible(Situation s) {
      return needs.stream().allMatch(c -> c.holds(s))
          && (flagNeeded < 0 || s.flags().get(flagNeeded));
    }

    Situation after(Situation s) {
      List<Double> levels = new ArrayList<>(s.levels());
      for (Change change : changes) {
        if (change.when() == null || change.when().holds(s)) {
          double by = change.by().value(s);
          double before = levels.get(change.quantity());
          double now =
              switch (change.how()) {
                case "assign" -> by;
                case "increase" -> before + by;
                default -> before - by;
              };
          levels.set(change.quantity(), Math.rint(now * 1e6) / 1e6 + 0.0);
        }
      }
      List<Boolean> flags = new ArrayList<>(s.flags());
      if (flagPut >= 0) {
        flags.set(flagPut, true);
      }
      return new Situation(List.copyOf(levels), List.copyOf(flags));
    }

    String precondition() {
      StringBuilder text = new StringBuilder("(and");
      needs.forEach(c -> text.append(' ').append(c));
      return text.append(flagNeeded < 0 ? "" : " (open f" + flagNeeded + ")")
          .append(")")
          .toString();
    }

    String effect() {
      StringBuilder text = new StringBuilder("(and");
      changes.forEach(c -> text.append(' ').append(c));
      return text.append(flagPut < 0 ? "" : " (open f" + flagPut + ")").append(")").toString();
    }
  }

  private final Random random;
  private final List<Double> levels = new ArrayList<>();
  private final List<Deed> deeds = new ArrayList<>();
  private final Set<Integer> absent = new LinkedHashSet<>();
  private final Set<Integer> barred = new LinkedHashSet<>();
  private final Goal goal;
  private final Reached reached;
  private final Reached withAll;

  NumericHome(long seed) {
    random = new Random(seed);
    int quantities = 1 + random.nextInt(3);
    for (int q = 0; q < quantities; q++) {
      levels.add((double) (random.nextBoolean() ? random.nextInt(4) : 10 * random.nextInt(10)));
    }
    if (random.nextInt(3) == 0) {
      dimmers();
    }
    int more = (deeds.isEmpty() ? 1 : 0) + random.nextInt(4);
    for (int i = 0; i < more; i++) {
      deeds.add(deed());
    }
    for (int i = 0; i < deeds.size(); i++) {
      switch (random.nextInt(8)) {
        case 0 -> absent.add(i);
        case 1 -> barred.add(i);
        default -> {}
      }
    }
    reached = reached(false);
    withAll = reached(true);
    goal = goal();
  }

  /** Some lamps whose settings add up to the light, which is the first quantity. */
  private void dimmers() {
    int lamps = 1 + random.nextInt(3);
    for (int lamp = 0; lamp < lamps; lamp++) {
      int setting = levels.size();
      levels.add(random.nextInt(3) / 2.0);
      double gain = 5 * (random.nextInt(9) - 1);
      boolean guarded = random.nextInt(4) == 0;
      for (double value : new double[] {0, 0.5, 1}) {
        Change light = new Change("increase", 0, new Amount(gain * value, -gain, setting), null);
        Change set = new Change("assign", setting, new Amount(value, 0, 0), null);
        List<Comparison> needs = guarded ? List.of(comparison()) : List.of();
        deeds.add(new Deed("lamp" + lamp, needs, -1, List.of(set, light), -1));
      }
    }
  }

  private Deed deed() {
    List<Comparison> needs = new ArrayList<>();
    List<Change> changes = new ArrayList<>();
    int count = 1 + random.nextInt(2);
    for (int i = 0; i < count; i++) {
      changes.add(change(needs));
    }
    if (random.nextInt(5) == 0) {
      needs.add(comparison());
    }
    return new Deed(
        "m" + random.nextInt(3),
        List.copyOf(needs),
        random.nextInt(5) == 0 ? random.nextInt(FLAGS) : -1,
        List.copyOf(changes),
        random.nextInt(4) == 0 ? random.nextInt(FLAGS) : -1);
  }

  /** Most changes are bounded: a stock is not below nothing, a vessel not more than full. */
  private Change change(List<Comparison> needs) {
    int quantity = random.nextInt(levels.size());
    double amount = random.nextBoolean() ? 1 + random.nextInt(3) : 10 * (1 + random.nextInt(4));
    boolean bounded = random.nextInt(12) > 0;
    Comparison when = random.nextInt(6) == 0 ? comparison() : null;
    switch (random.nextInt(6)) {
      case 0 -> {
        return new Change("assign", quantity, new Amount(amount, 0, 0), when);
      }
      case 1 -> {
        double factor = random.nextBoolean() ? 0.5 : 2;
        if (factor > 1) {
          needs.add(new Comparison(quantity, "<=", 60));
        } else {
          needs.add(new Comparison(quantity, ">", 1));
        }
        return new Change("assign", quantity, new Amount(0, factor, quantity), when);
      }
      case 2, 3 -> {
        if (bounded) {
          needs.add(new Comparison(quantity, ">=", amount));
        }
        return new Change("decrease", quantity, new Amount(amount, 0, 0), when);
      }
      default -> {
        if (bounded) {
          needs.add(new Comparison(quantity, "<=", 10 * (1 + random.nextInt(9))));
        }
        int other = random.nextInt(levels.size());
        boolean whole = random.nextInt(5) == 0 && other != quantity;
        return new Change(
            "increase",
            quantity,
            whole ? new Amount(amount, 1, other) : new Amount(amount, 0, 0),
            when);
      }
    }
  }

  private Comparison comparison() {
    String relation = List.of(">=", ">", "<=", "<").get(random.nextInt(4));
    return new Comparison(random.nextInt(levels.size()), relation, 5 * random.nextInt(20));
  }

  /** Mostly just out of reach. */
  private Goal goal() {
    int quantity = random.nextInt(levels.size());
    boolean highest = random.nextInt(3) > 0;
    double best = Math.max(-1e4, Math.min(1e4, reached.extreme(quantity, highest)));
    double beyond = best + (highest ? 1 : -1) * (random.nextInt(40) - 13);
    List<Comparison> comparisons = new ArrayList<>();
    comparisons.add(
        new Comparison(
            quantity, highest ? (random.nextBoolean() ? ">=" : ">") : "<=", Math.rint(beyond)));
    if (random.nextInt(4) == 0) {
      comparisons.add(comparison());
    }
    return new Goal(List.copyOf(comparisons), random.nextInt(5) == 0 ? random.nextInt(FLAGS) : -1);
  }

  private Reached reached(boolean withAll) {
    Situation first =
        new Situation(List.copyOf(levels), Arrays.asList(new Boolean[] {false, false}));
    Set<Situation> seen = new LinkedHashSet<>(List.of(first));
    Deque<Situation> open = new ArrayDeque<>(seen);
    while (!open.isEmpty() && seen.size() < MOST_STATES) {
      Situation from = open.remove();
      if (from.levels().stream().anyMatch(level -> Math.abs(level) > 1e6)) {
        return new Reached(seen, false);
      }
      for (int i = 0; i < deeds.size(); i++) {
        if ((withAll || isToBeHad(i)) && deeds.get(i).isPossible(from)) {
          Situation after = deeds.get(i).after(from);
          if (seen.add(after)) {
            open.add(after);
          }
        }
      }
    }
    return new Reached(seen, open.isEmpty());
  }

  private boolean isToBeHad(int deed) {
    return !absent.contains(deed) && !barred.contains(deed);
  }

  double level(int quantity) {
    return levels.get(quantity);
  }

  Goal goalOfTheHome() {
    return goal;
  }

  /** With those that are there, and do not refuse. */
  Reached reached() {
    return reached;
  }

  /** The same if everybody were there, and refused nothing. */
  Reached reachedWithAll() {
    return withAll;
  }

  PlanningTask task() {
    SmallWorld world =
        new SmallWorld()
            .word("level", "fluent", "?q - Quantity")
            .word("open", "", "?f - Flag")
            .individuals("Flag", "f0", "f1");
    for (int q = 0; q < levels.size(); q++) {
      world
          .individuals("Quantity", "q" + q)
          .facts("(= (level q%d) %s)".formatted(q, levels.get(q)));
    }
    List<Unavailable> unavailable = new ArrayList<>();
    Set<StepKey> refused = new LinkedHashSet<>();
    for (int i = 0; i < deeds.size(); i++) {
      Deed deed = deeds.get(i);
      world.feature("d" + i, "", deed.precondition(), deed.effect());
      world.offer(deed.member(), "d" + i, "1");
      if (absent.contains(i)) {
        unavailable.add(new Unavailable(world.offers.remove(world.offers.size() - 1), "lost"));
      } else if (barred.contains(i)) {
        refused.add(new StepKey(deed.member(), "d" + i, Map.of()));
      }
    }
    return world.task(goal.toString()).withBarred(refused).withUnavailable(unavailable, Map.of());
  }

  /** All of it, to be read where a seed failed. */
  @Override
  public String toString() {
    StringBuilder text = new StringBuilder("levels %s, goal %s%n".formatted(levels, goal));
    Consumer<Integer> tell =
        i ->
            text.append(
                "d%d of %s%s%s: %s -> %s%n"
                    .formatted(
                        i,
                        deeds.get(i).member(),
                        absent.contains(i) ? " (absent)" : "",
                        barred.contains(i) ? " (refused)" : "",
                        deeds.get(i).precondition(),
                        deeds.get(i).effect()));
    for (int i = 0; i < deeds.size(); i++) {
      tell.accept(i);
    }
    return text.toString();
  }
}
