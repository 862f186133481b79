package org.maestro.coordination;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.PricedFeature.ExactPrice;
import org.maestro.planning.StepKey;
import org.maestro.sl.Term;

/** The prices that members computed when asked, kept until the member's own state changes. */
final class ExactPrices {
  /** An empty price: the member declined. */
  private final Map<String, Map<StepKey, Optional<ExactPrice>>> byMember = new HashMap<>();

  void put(StepKey key, Optional<ExactPrice> price) {
    byMember.computeIfAbsent(key.member(), m -> new HashMap<>()).put(key, price);
  }

  void forget(String member) {
    byMember.remove(member);
  }

  Map<Map<String, Term>, ExactPrice> of(String member, String feature) {
    Map<Map<String, Term>, ExactPrice> prices = new HashMap<>();
    byMember
        .getOrDefault(member, Map.of())
        .forEach(
            (key, price) -> {
              if (key.feature().equals(feature)) {
                price.ifPresent(p -> prices.put(key.bindings(), p));
              }
            });
    return prices;
  }

  /** Instances that their member declined to price: nobody plans with them. */
  java.util.Set<StepKey> declined() {
    java.util.Set<StepKey> declined = new java.util.HashSet<>();
    byMember.values().stream()
        .flatMap(m -> m.entrySet().stream())
        .filter(e -> e.getValue().isEmpty())
        .forEach(e -> declined.add(e.getKey()));
    return declined;
  }
}
