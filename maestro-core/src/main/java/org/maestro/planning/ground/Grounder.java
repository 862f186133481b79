package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.util.Arrays;
import java.util.List;

/**
 * Makes a task with parameters ground: only what can be reached, and only what can matter for the
 * goal.
 */
public final class Grounder {
  private final LiftedTask task;
  private final Relation[] relations;
  private final boolean[] changing;

  private Grounder(LiftedTask task) {
    this.task = task;
    int symbols = task.predicates().size();
    changing = new boolean[symbols];
    for (Schema schema : task.schemas()) {
      schema.additions().forEach(atom -> changing[atom.symbol()] = true);
      schema.deletions().forEach(atom -> changing[atom.symbol()] = true);
    }
    relations = new Relation[symbols];
    Arrays.setAll(relations, symbol -> new Relation(task.objects().size()));
    for (Atom atom : task.initial()) {
      if (!changing[atom.symbol()] && relations[atom.symbol()].number(atom.terms()) < 0) {
        relations[atom.symbol()].add(atom.terms());
      }
    }
  }

  /**
   * The ground task.
   *
   * @throws java.util.concurrent.CancellationException when patience is over before
   * @throws GroundingException when the task is of a kind that cannot be solved
   */
  public static GroundTask ground(LiftedTask task, Patience patience) {
    return new Grounder(task).ground(patience);
  }

  private GroundTask ground(Patience patience) {
    Relation[] statics = new Relation[relations.length];
    for (int symbol = 0; symbol < statics.length; symbol++) {
      statics[symbol] = changing[symbol] ? null : relations[symbol];
    }
    RelevantAtoms relevant = new RelevantAtoms(task, statics, patience);
    List<Instances.Instance> instances =
        new Instances(task, relations, changing, relevant, patience).find();
    return new Numbering(task, relations, changing, patience).number(instances);
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
