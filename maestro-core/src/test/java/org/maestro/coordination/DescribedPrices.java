package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.SteppedClock;

/**
 * A contract net without members: whoever is present proposes the prices that the home describes.
 */
final class DescribedPrices implements ContractNet {
  private static final Duration ROUND = Duration.ofMillis(2);

  private final SteppedClock clock;
  private final KnowledgeBase knowledge;
  private final Predicate<String> isPresent;
  private final BiFunction<String, String, Quote> exact;

  /**
   * @param exact what a member (first) says when it is asked for the exact price of a feature
   */
  DescribedPrices(
      SteppedClock clock,
      KnowledgeBase knowledge,
      Predicate<String> isPresent,
      BiFunction<String, String, Quote> exact) {
    this.clock = clock;
    this.knowledge = knowledge;
    this.isPresent = isPresent;
    this.exact = exact;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    List<Proposal> proposals = new ArrayList<>();
    call.features().forEach((member, names) -> proposals.add(proposal(member, names)));
    clock.schedule(ROUND, "prices", () -> closed.accept(new Proposed(proposals)));
  }

  private Proposal proposal(String member, List<String> names) {
    if (!isPresent.test(member)) {
      return new Proposal(member, Map.of(), Optional.of("not there"));
    }
    Map<String, Price> prices = new TreeMap<>();
    for (FeatureType feature : knowledge.home().devices().get(member).features()) {
      if (names.contains(feature.name())) {
        prices.put(feature.name(), feature.cost());
      }
    }
    return new Proposal(member, prices, Optional.empty());
  }

  /** Who does not answer is known not to at once. */
  @Override
  public void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    Quote quote = exact.apply(member, feature);
    clock.schedule(
        quote instanceof Quote.Unanswered ? Duration.ZERO : ROUND,
        member,
        () -> answer.accept(sets.stream().map(set -> quote).toList()));
  }

  /** Nobody waits for an award. */
  private record Proposed(List<Proposal> bids) implements Round {
    @Override
    public void award(Map<String, List<Step>> parts) {
      // The steps come as orders.
    }
  }
}
