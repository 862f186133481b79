package org.maestro.planning.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Predicates of which one is the middle of a wheel: it is exchanged for one of the others, the
 * spokes, and each of these again only for it, as a free hand for something held. To come back to
 * the middle, only such spokes need to be left that something else wants to be entered, or that
 * hold at first: to enter one in order to leave it again is of no use (compare Haslum, Helmert and
 * Jonsson 2013).
 */
final class MutexGroups {
  /**
   * @param places where each of the middle's terms stands in the spoke
   */
  private record Spoke(int symbol, int[] places) {}

  private final LiftedTask task;
  private final GroundingBudget patience;
  private final Map<Integer, List<Spoke>> spokesOf = new HashMap<>();
  private final BitSet symbols = new BitSet();

  /**
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  MutexGroups(LiftedTask task, GroundingBudget patience) {
    this.task = task;
    this.patience = patience;
    for (int symbol = 0; symbol < task.predicates().size(); symbol++) {
      List<Spoke> spokes = candidates(symbol);
      if (!spokes.isEmpty() && isWheel(symbol, spokes)) {
        spokesOf.put(symbol, spokes);
        spokes.forEach(spoke -> symbols.set(spoke.symbol()));
      }
    }
  }

  /** The spoke that a schema leaves when it brings about the middle; empty when there is none. */
  Optional<Atom> left(Schema schema, Atom middle) {
    List<Spoke> spokes = spokesOf.get(middle.symbol());
    if (spokes == null) {
      return Optional.empty();
    }
    return exchanged(schema).stream()
        .filter(atom -> spokes.stream().anyMatch(spoke -> fits(spoke, atom, middle)))
        .findFirst();
  }

  boolean isSpoke(int symbol) {
    return symbols.get(symbol);
  }

  private List<Spoke> candidates(int middle) {
    List<Spoke> result = new ArrayList<>();
    for (Schema schema : task.schemas()) {
      patience.check();
      for (Atom added : schema.additions()) {
        if (added.symbol() == middle) {
          for (Atom left : exchanged(schema)) {
            places(left, added)
                .map(places -> new Spoke(left.symbol(), places))
                .filter(
                    spoke ->
                        result.stream()
                            .noneMatch(
                                known ->
                                    known.symbol() == spoke.symbol()
                                        && Arrays.equals(known.places(), spoke.places())))
                .ifPresent(result::add);
          }
        }
      }
    }
    return result;
  }

  /** Where the middle's terms stand in the spoke, which has to have more. */
  private static Optional<int[]> places(Atom spoke, Atom middle) {
    if (spoke.symbol() == middle.symbol() || spoke.terms().length <= middle.terms().length) {
      return Optional.empty();
    }
    int[] places = new int[middle.terms().length];
    for (int i = 0; i < places.length; i++) {
      places[i] = -1;
      for (int place = 0; place < spoke.terms().length; place++) {
        if (spoke.terms()[place] == middle.terms()[i]) {
          places[i] = place;
        }
      }
      if (places[i] < 0) {
        return Optional.empty();
      }
    }
    return Optional.of(places);
  }

  private static boolean fits(Spoke spoke, Atom left, Atom middle) {
    if (spoke.symbol() != left.symbol()) {
      return false;
    }
    for (int i = 0; i < spoke.places().length; i++) {
      if (left.terms()[spoke.places()[i]] != middle.terms()[i]) {
        return false;
      }
    }
    return true;
  }

  /** What a schema needs and deletes. */
  private static List<Atom> exchanged(Schema schema) {
    List<Atom> exchanged = new ArrayList<>();
    for (Atom atom : schema.deletions()) {
      if (schema.conditions().contains(new Literal(atom, true))
          && !schema.additions().contains(atom)) {
        exchanged.add(atom);
      }
    }
    return exchanged;
  }

  /** Whether at each moment at most one of the middle and its spokes holds, for each key. */
  private boolean isWheel(int middle, List<Spoke> spokes) {
    long symbols = spokes.stream().mapToInt(Spoke::symbol).distinct().count();
    return symbols == spokes.size()
        && task.schemas().stream().allMatch(schema -> keeps(schema, middle, spokes))
        && holdsAtFirst(middle, spokes);
  }

  private boolean keeps(Schema schema, int middle, List<Spoke> spokes) {
    patience.check();
    List<Atom> left = new ArrayList<>();
    for (Atom added : schema.additions()) {
      List<Atom> matching =
          exchanged(schema).stream()
              .filter(
                  atom ->
                      added.symbol() == middle
                          ? spokes.stream().anyMatch(spoke -> fits(spoke, atom, added))
                          : atom.symbol() == middle
                              && spokes.stream().anyMatch(spoke -> fits(spoke, added, atom)))
              .toList();
      boolean concerned =
          added.symbol() == middle
              || spokes.stream().anyMatch(spoke -> spoke.symbol() == added.symbol());
      if (concerned) {
        // Two exchanges of one schema could be of the same key, if their terms became equal.
        if (matching.size() != 1 || !left.isEmpty()) {
          return false;
        }
        left.addAll(matching);
      }
    }
    return true;
  }

  private boolean holdsAtFirst(int middle, List<Spoke> spokes) {
    Map<List<Integer>, Integer> weights = new HashMap<>();
    for (Atom atom : task.initial()) {
      patience.check();
      if (atom.symbol() == middle) {
        weights.merge(Arrays.stream(atom.terms()).boxed().toList(), 1, Integer::sum);
      }
      for (Spoke spoke : spokes) {
        if (spoke.symbol() == atom.symbol()) {
          weights.merge(
              Arrays.stream(spoke.places()).mapToObj(place -> atom.terms()[place]).toList(),
              1,
              Integer::sum);
        }
      }
    }
    return weights.values().stream().allMatch(weight -> weight <= 1);
  }
}
