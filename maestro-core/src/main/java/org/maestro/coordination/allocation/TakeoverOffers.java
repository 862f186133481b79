package org.maestro.coordination.allocation;

import java.time.Duration;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.Takeover;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;

/**
 * The choice of those offers to take over a running step that are worth a plan (Three-layered
 * architecture, 3.2.1; M43). Whoever is expected to be done for less than what is offered keeps its
 * step without much ado; the number of offers for one step is bounded, so that nobody is kept from
 * working by being offered help. The coordinator's thread only.
 */
public final class TakeoverOffers {
  private static final int MOST_FOR_A_STEP = 3;

  private final Map<StepKey, Duration> begunAt = new HashMap<>();
  private final Map<StepKey, Integer> considered = new HashMap<>();
  private final Map<StepKey, Step> late = new LinkedHashMap<>();

  public void begun(Step step, Duration now) {
    begunAt.put(step.key(), now);
    late.remove(step.key());
  }

  /**
   * What is left of a step whose member is late: nobody knows, and its own word has proved wrong.
   * It counts as much as has passed already, so that it is relieved by who is quicker, and not by
   * who would first have to undo what it did.
   */
  public Optional<ContractNet.Quote> priceIfLate(Step step, Takeover offer, Duration now) {
    if (!isLate(step, offer, now)) {
      return Optional.empty();
    }
    late.put(step.key(), step);
    double passed = passed(step, now).orElse(0.0);
    return Optional.of(new ContractNet.Quote.Priced(Math.max(step.cost(), passed), passed));
  }

  /** Steps that were late when others offered to take them over, without those that are wanted. */
  public Stream<Step> lateBeside(Collection<Step> wanted) {
    Set<StepKey> keys = wanted.stream().map(Step::key).collect(Collectors.toSet());
    return late.values().stream().filter(step -> !keys.contains(step.key()));
  }

  /** Whether its member is late by longer than the other would need for all of it. */
  private boolean isLate(Step step, Takeover offer, Duration now) {
    return passed(step, now).filter(p -> p >= step.seconds() + offer.seconds()).isPresent();
  }

  /** Returns why it should be planned again, if it should. */
  public Optional<String> reason(Step step, String sentence, Takeover offer, Duration now) {
    double passed = passed(step, now).orElse(0.0);
    double left = step.cost() * Math.max(0, 1 - passed / Math.max(step.seconds(), 1e-3));
    boolean late = isLate(step, offer, now);
    if (!late && offer.cost() >= left
        || considered.merge(step.key(), 1, Integer::sum) > MOST_FOR_A_STEP) {
      return Optional.empty();
    }
    return Optional.of(
        late
            ? "%s offers to do it for %s, and step %d (%s) takes %s s already, %s were expected"
                .formatted(
                    offer.by(),
                    Sentences.number(offer.cost()),
                    step.number(),
                    sentence,
                    Sentences.number(passed),
                    Sentences.number(step.seconds()))
            : "%s offers to do for %s what is left of step %d (%s), for which %s is still expected"
                .formatted(
                    offer.by(),
                    Sentences.number(offer.cost()),
                    step.number(),
                    sentence,
                    Sentences.number(left)));
  }

  private Optional<Double> passed(Step step, Duration now) {
    return Optional.ofNullable(begunAt.get(step.key())).map(at -> now.minus(at).toNanos() / 1e9);
  }
}
