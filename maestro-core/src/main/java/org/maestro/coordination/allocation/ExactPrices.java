package org.maestro.coordination.allocation;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.maestro.coordination.api.ContractNet.Quote;
import org.maestro.planning.api.PricedFeature.ExactPrice;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Term;

/**
 * The answers of members that were asked for exact prices, kept until the member's own state
 * changes. Silence is no refusal: it counts for five times as long as was waited in vain, so that a
 * silent member costs no goal more than a sixth of its time, and then the member is asked again.
 */
public final class ExactPrices {
  private static final int TIMES_THE_WAIT = 5;

  /**
   * @param until when an unanswered question may be asked again; no meaning for the others
   */
  private record Known(Quote quote, Duration until) {}

  private final Map<String, Map<StepKey, Known>> byMember = new HashMap<>();

  /**
   * @param asked when the question was put
   * @param now when the answer came, or was not waited for any more
   */
  public void put(StepKey key, Quote quote, Duration asked, Duration now) {
    Duration until = now.plus(now.minus(asked).multipliedBy(TIMES_THE_WAIT));
    byMember.computeIfAbsent(key.member(), m -> new HashMap<>()).put(key, new Known(quote, until));
  }

  public void forget(String member) {
    byMember.remove(member);
  }

  /** Returns whether there was a question without an answer. */
  boolean forgetUnanswered() {
    boolean any = false;
    for (Map<StepKey, Known> quotes : byMember.values()) {
      any |= quotes.values().removeIf(known -> known.quote() instanceof Quote.Unanswered);
    }
    return any;
  }

  Map<Map<String, Term>, ExactPrice> of(String member, String feature) {
    Map<Map<String, Term>, ExactPrice> prices = new HashMap<>();
    byMember
        .getOrDefault(member, Map.of())
        .forEach(
            (key, known) -> {
              if (key.feature().equals(feature) && known.quote() instanceof Quote.Priced priced) {
                prices.put(key.bindings(), new ExactPrice(priced.cost(), priced.seconds()));
              }
            });
    return prices;
  }

  /** Instances for which their member gives no answer: nobody plans so. */
  public Set<StepKey> unusable(Duration now) {
    Set<StepKey> keys = new HashSet<>();
    byMember.values().stream()
        .flatMap(m -> m.entrySet().stream())
        .filter(e -> e.getValue().quote() instanceof Quote.Unanswered)
        .filter(e -> e.getValue().until().compareTo(now) > 0)
        .forEach(e -> keys.add(e.getKey()));
    return keys;
  }
}
