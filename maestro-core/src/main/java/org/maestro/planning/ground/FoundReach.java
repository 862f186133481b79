package org.maestro.planning.ground;

import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The reach of the instances that were found. */
final class FoundReach implements Reach {
  private final Relation[] holding;
  private final Set<Atom> initial;
  private final Set<Atom> deleted = new HashSet<>();

  /**
   * @param holding of each predicate the tuples that may hold
   */
  FoundReach(LiftedTask task, Relation[] holding, List<Instances.Instance> instances) {
    this.holding = holding;
    this.initial = new HashSet<>(task.initial());
    for (Instances.Instance instance : instances) {
      for (Atom atom : task.schema(instance.schema()).deletions()) {
        deleted.add(new Atom(atom.symbol(), atom.ground(instance.binding())));
      }
    }
  }

  @Override
  public boolean mayHold(int predicate, int[] pattern) {
    Relation.Matches matches = holding[predicate].matching(pattern);
    for (int i = 0; i < matches.size(); i++) {
      if (agree(pattern, holding[predicate].tuple(matches.numbers()[i]))) {
        return true;
      }
    }
    return false;
  }

  private static boolean agree(int[] pattern, int[] tuple) {
    for (int i = 0; i < pattern.length; i++) {
      if (pattern[i] >= 0 && pattern[i] != tuple[i]) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean mayLack(int predicate, int[] objects) {
    Atom atom = new Atom(predicate, objects);
    return !initial.contains(atom) || deleted.contains(atom);
  }
}
