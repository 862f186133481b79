package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/**
 * Makes a task with parameters ground: only what can be reached, and only what can matter for the
 * goal.
 */
public final class Grounder implements GrowingTask {
  /** Of sums of costs, as a part of them. */
  private static final double ROUNDING = 1e-9;

  private final LiftedTask task;
  private final Relation[] relations;
  private final boolean[] changing;
  private final Instances instances;
  private BigDecimal unit = BigDecimal.ONE;
  private GroundTask ground;

  private Grounder(LiftedTask task, double cost, GroundingBudget patience) {
    this.task = task;
    changing = changing(task);
    relations = unchanging(task, changing, patience);
    @Nullable Relation[] statics = new Relation[relations.length];
    Arrays.setAll(statics, symbol -> changing[symbol] ? null : relations[symbol]);
    instances =
        new Instances(
            task, relations, changing, new RelevantAtoms(task, statics, patience), patience);
    number(cost, patience);
  }

  /** The predicates that any step changes. */
  private static boolean[] changing(LiftedTask task) {
    boolean[] changing = new boolean[task.predicates().size()];
    for (Schema schema : task.schemas()) {
      schema.additions().forEach(atom -> changing[atom.symbol()] = true);
      schema.deletions().forEach(atom -> changing[atom.symbol()] = true);
    }
    return changing;
  }

  /** Of each predicate the tuples, if it does not change; of the others none. */
  private static Relation[] unchanging(
      LiftedTask task, boolean[] changing, GroundingBudget patience) {
    Relation[] relations = new Relation[changing.length];
    Arrays.setAll(relations, symbol -> new Relation(task.objects().size()));
    for (Atom atom : task.initial()) {
      patience.check();
      if (!changing[atom.symbol()] && relations[atom.symbol()].number(atom.terms()) < 0) {
        relations[atom.symbol()].add(atom.terms());
      }
    }
    return relations;
  }

  /**
   * What may come to hold, whether it matters for the goal or not.
   *
   * @throws java.util.concurrent.CancellationException when patience is over before
   */
  public static Reach reach(LiftedTask task, GroundingBudget patience) {
    boolean[] changing = changing(task);
    Relation[] relations = unchanging(task, changing, patience);
    Instances instances = new Instances(task, relations, changing, Relevance.OF_ALL, patience);
    instances.find(Double.POSITIVE_INFINITY, patience);
    return new FoundReach(task, numbered(relations, changing, instances), instances.found());
  }

  /**
   * The ground task.
   *
   * @throws java.util.concurrent.CancellationException when patience is over before
   * @throws GroundingException when the task is of a kind that cannot be solved
   */
  public static GroundTask ground(LiftedTask task, GroundingBudget patience) {
    return new Grounder(task, Double.POSITIVE_INFINITY, patience).ground;
  }

  /**
   * The task as far as it takes to reach the goal when nothing that once held ceases to; the rest
   * follows as it grows.
   *
   * @throws java.util.concurrent.CancellationException when patience is over before
   * @throws GroundingException when the task is of a kind that cannot be solved
   */
  public static GrowingTask growing(LiftedTask task, GroundingBudget patience) {
    return new Grounder(task, 0, patience);
  }

  @Override
  public GroundTask task() {
    return ground;
  }

  @Override
  public long beyond() {
    double cost = instances.beyond();
    return cost == Double.POSITIVE_INFINITY
        ? Long.MAX_VALUE
        : (long) Math.floor(cost * (1 - ROUNDING) * ground.unit().doubleValue());
  }

  @Override
  public void grow(long cost, GroundingBudget patience) {
    if (cost > beyond()) {
      number(cost / ground.unit().doubleValue() * (1 + ROUNDING), patience);
    }
  }

  private void number(double cost, GroundingBudget patience) {
    instances.find(cost, patience);
    boolean isWhole = instances.beyond() == Double.POSITIVE_INFINITY;
    ground =
        new Numbering(task, numbered(relations, changing, instances), changing, unit, patience)
            .number(instances.found(), isWhole);
    unit = ground.unit();
  }

  private static Relation[] numbered(
      Relation[] relations, boolean[] changing, Instances instances) {
    Relation[] numbered = new Relation[relations.length];
    Arrays.setAll(
        numbered, symbol -> changing[symbol] ? instances.seen()[symbol] : relations[symbol]);
    return numbered;
  }

  /** How often a unit of the values' last decimal place goes into 1. */
  static BigDecimal unit(Iterable<BigDecimal> values) {
    int places = 0;
    for (BigDecimal value : values) {
      places = Math.max(places, Math.min(9, value.stripTrailingZeros().scale()));
    }
    return BigDecimal.ONE.scaleByPowerOfTen(places);
  }
}
