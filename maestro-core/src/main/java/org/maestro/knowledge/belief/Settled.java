package org.maestro.knowledge.belief;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.sl.Term;

/**
 * The belief about a state variable after its claims were weighed.
 *
 * @param excluded values that it is known not to have
 * @param losers claims that a surer one contradicts
 */
record Settled(Optional<Held> value, Map<Term, Held> excluded, List<Claim> losers) {

  private static final Settled NOTHING = new Settled(Optional.empty(), Map.of(), List.of());

  /**
   * @param standing the best first
   */
  static Settled of(List<Claim> standing) {
    if (standing.isEmpty()) {
      return NOTHING;
    }
    Claim best = standing.get(0);
    if (standing.size() == 1) {
      return best.has()
          ? new Settled(Optional.of(best.held()), Map.of(), List.of())
          : new Settled(Optional.empty(), Map.of(best.value(), best.held()), List.of());
    }
    Optional<Held> value = Optional.empty();
    Map<Term, Held> excluded = new LinkedHashMap<>();
    List<Claim> losers = new ArrayList<>();
    for (Claim claim : standing) {
      boolean contradicted =
          claim.has()
              ? excluded.containsKey(claim.value())
                  || value.filter(held -> !held.value().equals(claim.value())).isPresent()
              : value.filter(held -> held.value().equals(claim.value())).isPresent();
      if (contradicted) {
        losers.add(claim);
      } else if (!claim.has()) {
        excluded.putIfAbsent(claim.value(), claim.held());
      } else if (value.isEmpty()) {
        value = Optional.of(claim.held());
      }
    }
    return new Settled(value, Collections.unmodifiableMap(excluded), List.copyOf(losers));
  }
}
