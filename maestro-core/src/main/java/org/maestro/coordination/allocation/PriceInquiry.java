package org.maestro.coordination.allocation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Supplier;
import org.maestro.coordination.api.CallArguments;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Sentences;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The members' answers to what single steps cost, in one planning round: exact prices become known,
 * steps that are declined or of which nobody says anything do not count in this round. For the
 * thread of the round.
 */
final class PriceInquiry {
  /** How often it is asked again before a goal is given up because of prices not named. */
  private static final int LAST_CHANCES = 2;

  private static final double SAME_PRICE = 1e-9;

  private final String goalId;
  private final Ports ports;
  private final ExactPrices exactPrices;
  private final PriceQuestions priceQuestions;
  private final Supplier<? extends Facts> facts;
  private final Set<String> unpriced = new LinkedHashSet<>();
  private final Set<StepKey> declined = new HashSet<>();
  private final Set<StepKey> unanswered = new HashSet<>();
  private final Map<StepKey, String> reasons = new HashMap<>();
  private int asked;
  private int lastChances;

  PriceInquiry(
      String goalId,
      Ports ports,
      ExactPrices exactPrices,
      PriceQuestions priceQuestions,
      Supplier<? extends Facts> facts) {
    this.goalId = goalId;
    this.ports = ports;
    this.exactPrices = exactPrices;
    this.priceQuestions = priceQuestions;
    this.facts = facts;
  }

  /** Steps that nobody is to count on now. */
  Set<StepKey> unusable() {
    Set<StepKey> unusable = new HashSet<>(declined);
    unusable.addAll(unanswered);
    unusable.addAll(exactPrices.unusable(ports.clock().now()));
    return unusable;
  }

  /** Why some of them are not. */
  Map<StepKey, String> reasons() {
    return reasons;
  }

  /** How many prices were asked for. */
  int asked() {
    return asked;
  }

  /** Sentences about prices that were not named or cannot be, the member's name first. */
  List<String> unpriced() {
    return List.copyOf(unpriced);
  }

  /**
   * Asks each member for all that is open of one of its features at once, and goes on when all have
   * answered, or did not in time.
   *
   * @param trusted steps that stay possible where they are declined now
   */
  void ask(List<OpenPrice> open, Set<StepKey> trusted, CallArguments arguments, Runnable answered) {
    Duration begun = ports.clock().now();
    Map<List<String>, List<OpenPrice>> byFeature = new LinkedHashMap<>();
    open.forEach(
        price ->
            byFeature
                .computeIfAbsent(
                    List.of(price.step().member(), price.step().feature()), k -> new ArrayList<>())
                .add(price));
    asked += open.size();
    int[] awaited = {byFeature.size()};
    byFeature.forEach(
        (memberAndFeature, prices) ->
            ports
                .contractNet()
                .exactPrices(
                    goalId,
                    memberAndFeature.get(0),
                    memberAndFeature.get(1),
                    prices.stream()
                        .map(price -> arguments.of(price.feature(), price.step().bindings()))
                        .toList(),
                    quotes -> {
                      note(prices, quotes, begun, trusted);
                      if (--awaited[0] == 0) {
                        answered.run();
                      }
                    }));
  }

  /**
   * What nobody answered is no reason to say that it cannot be done, as long as it may be asked.
   */
  boolean mayAskAgain() {
    boolean again =
        lastChances < LAST_CHANCES && (exactPrices.forgetUnanswered() || !unanswered.isEmpty());
    lastChances++;
    unanswered.clear();
    return again;
  }

  private void note(
      List<OpenPrice> prices,
      List<ContractNet.Quote> quotes,
      Duration begun,
      Set<StepKey> trusted) {
    for (int i = 0; i < prices.size(); i++) {
      OpenPrice price = prices.get(i);
      StepKey step = price.step();
      ContractNet.Quote quote =
          i < quotes.size()
              ? expected(quotes.get(i), price.feature())
              : new ContractNet.Quote.Unanswered("named too few prices");
      if (quote instanceof ContractNet.Quote.Priced priced
          && priced.cost() < price.cost() - SAME_PRICE
          && !priceQuestions.isReckoned(price)) {
        unpriced.add(
            "%s (%s: it names %s, and had said at least %s, which counts)"
                .formatted(
                    step.member(),
                    step.feature(),
                    Sentences.number(priced.cost()),
                    Sentences.number(price.cost())));
        quote = new ContractNet.Quote.Priced(price.cost(), priced.seconds());
      }
      if (quote instanceof ContractNet.Quote.Declined declined) {
        decline(price, begun, trusted.contains(step));
        reasons.put(step, "it names no price: " + declined.reason());
        unpriced.add("%s (%s: %s)".formatted(step.member(), step.feature(), declined.reason()));
      } else if (quote instanceof ContractNet.Quote.Unanswered silence) {
        exactPrices.put(step, quote, begun, ports.clock().now());
        unanswered.add(step);
        reasons.put(step, silence.reason());
        unpriced.add("%s (%s)".formatted(step.member(), silence.reason()));
      } else {
        priceQuestions.answered(price, ((ContractNet.Quote.Priced) quote).cost());
        exactPrices.put(step, quote, begun, ports.clock().now());
      }
    }
  }

  /** A member prices one call; a plan counts those that it takes in the mean. */
  private static ContractNet.Quote expected(ContractNet.Quote quote, FeatureType feature) {
    return quote instanceof ContractNet.Quote.Priced priced
        ? new ContractNet.Quote.Priced(
            priced.cost() * feature.reliability().expectedCalls(), priced.seconds())
        : quote;
  }

  /**
   * A member prices what it could do now. That it cannot do what earlier steps have yet to make
   * possible, such as going through a door that is still shut, says nothing: the lower bound
   * stands. Any other refusal holds for this round only, since it may be due to what others do just
   * now.
   */
  private void decline(OpenPrice price, Duration begun, boolean trusted) {
    if (isPossibleNow(price) && !trusted) {
      declined.add(price.step());
    } else {
      exactPrices.put(
          price.step(),
          new ContractNet.Quote.Priced(price.cost(), price.seconds()),
          begun,
          ports.clock().now());
    }
  }

  private boolean isPossibleNow(OpenPrice price) {
    Map<String, Term> bindings = price.step().values();
    return new Evaluation(facts.get()).truth(price.feature().precondition(), bindings)
        == Truth.TRUE;
  }
}
