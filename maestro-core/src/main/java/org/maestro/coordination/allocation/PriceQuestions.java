package org.maestro.coordination.allocation;

import java.util.ArrayList;
import java.util.DoubleSummaryStatistics;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.PlanningResult.Found;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/**
 * The exact prices to ask for next in one planning round: those of the plan's own steps, and those
 * that may make another plan the cheapest. A plan is made for each set of answers, and answers cost
 * far less than plans: where they only led to another plan of lower bounds, more and more steps are
 * asked for at once, and in the end those that nobody asked for count as if they cost what the
 * cheapest like one was said to, or at last what like ones cost in the mean. For one thread.
 */
final class PriceQuestions {
  /** Steps that are asked for besides those of the first plan. */
  private static final int FIRST_RIVALS = 8;

  /** From one plan to the next. */
  private static final int MORE_RIVALS = 4;

  private static final int MOST_RIVALS = 128;

  /** A member may have to search for a way for each, and has 50 ms for one question. */
  private static final int MOST_OF_ONE = 8;

  /** Plans of lower bounds, after which what is not known is reckoned by what is. */
  private static final int MOST_PLANS_OF_BOUNDS = 3;

  /** Plans, after which it is reckoned by the mean: what is always hoped for is never known. */
  private static final int MOST_PLANS_OF_HOPE = 5;

  private final Map<String, DoubleSummaryStatistics> answers = new HashMap<>();

  /** What counted for a feature when it was planned last: answers that come in change the rest. */
  private final Map<String, Double> counted = new HashMap<>();

  private int plans;
  private int rivals = FIRST_RIVALS;
  private double provenAtLeast;

  /** What the plan's own open prices are, and those that are worth asking for with them. */
  List<OpenPrice> next(Found found) {
    List<OpenPrice> open = new ArrayList<>();
    for (Step step : found.plan().steps()) {
      if (!step.exactPrice()) {
        open.add(new OpenPrice(step.key(), step.feature(), step.cost(), step.seconds()));
      }
    }
    if (open.isEmpty()) {
      return open;
    }
    if (!isReckoning() && isProof(found)) {
      provenAtLeast = Math.max(provenAtLeast, found.plan().cost());
    }
    Map<String, Integer> ofMember = new HashMap<>();
    found.rivals().stream()
        .filter(rival -> ofMember.merge(rival.step().member(), 1, Integer::sum) <= MOST_OF_ONE)
        .limit(rivals)
        .forEach(open::add);
    rivals = Math.min(MOST_RIVALS, MORE_RIVALS * rivals);
    plans++;
    return open;
  }

  void answered(OpenPrice price, double cost) {
    answers
        .computeIfAbsent(price.step().feature(), absent -> new DoubleSummaryStatistics())
        .accept(cost);
  }

  /** Whether what is not known is reckoned by what is. */
  private boolean isReckoning() {
    return plans >= MOST_PLANS_OF_BOUNDS;
  }

  /** Whether the price is what like steps cost, and not what its own member said. */
  boolean isReckoned(OpenPrice price) {
    Double expected = counted.get(price.step().feature());
    return expected != null && price.cost() <= expected;
  }

  /** The offers, with what counts for the prices that nobody asked for. */
  List<PricedFeature> reckoned(List<PricedFeature> offers) {
    if (!isReckoning()) {
      return offers;
    }
    answers.forEach(
        (feature, told) ->
            counted.put(feature, plans < MOST_PLANS_OF_HOPE ? told.getMin() : told.getAverage()));
    return offers.stream().map(this::reckoned).toList();
  }

  private PricedFeature reckoned(PricedFeature offer) {
    Double answer = counted.get(offer.type().name());
    if (answer == null || !(offer.price() instanceof Price.Asked asked)) {
      return offer;
    }
    Expression expected =
        new Expression.Arithmetic(
            Expression.Operator.MAX,
            List.of(asked.atLeast(), new Expression.OfTerm(new Term.Number(answer))));
    return new PricedFeature(
        offer.member(), offer.type(), new Price.Asked(expected), offer.exact());
  }

  /** A plan that weighs where to look is not called the best of all anyway. */
  private static boolean isProof(Found found) {
    return found.atLeast().isEmpty() && found.plan().searches().isEmpty();
  }

  /** The plan found, called the best only where lower bounds prove it. */
  Found proven(Found found) {
    return isReckoning() && isProof(found)
        ? new Found(
            found.plan(),
            OptionalDouble.of(Math.min(provenAtLeast, found.plan().cost())),
            found.contenders(),
            found.rivals())
        : found;
  }
}
