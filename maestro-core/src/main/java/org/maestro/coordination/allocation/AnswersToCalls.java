package org.maestro.coordination.allocation;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.BidRecord.Kind;
import org.maestro.coordination.api.Proposal;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.PricedFeature.ExactPrice;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Term;

/** The answers of one planning round, set against the steps of the plan that came of it. */
final class AnswersToCalls {
  private final PlanningTask task;
  private final List<Step> plan;
  private final Map<String, List<PricedFeature>> offers;
  private final Evaluation evaluation;

  /**
   * @param plan its steps; none where there is no plan
   */
  AnswersToCalls(PlanningTask task, List<Step> plan) {
    this.task = task;
    this.plan = plan;
    this.offers = task.features().stream().collect(Collectors.groupingBy(PricedFeature::member));
    this.evaluation = new Evaluation(task.facts());
  }

  /** Those of who was asked, then of single steps that cannot be, then who was not asked. */
  List<BidRecord> of(CandidateProposals tender) {
    Set<BidRecord> rows = new LinkedHashSet<>();
    for (Proposal bid : tender.bids()) {
      for (String feature : tender.candidateFeatures(bid.member())) {
        rows.addAll(answers(bid, feature));
      }
    }
    task.whyBarred()
        .forEach(
            (key, reason) ->
                rows.add(
                    row(
                        stepLike(key),
                        key.member(),
                        key.feature(),
                        new BidRecord.Refused(reason))));
    Set<String> asked = tender.bids().stream().map(Proposal::member).collect(Collectors.toSet());
    for (Unavailable missing : task.unavailable()) {
      PricedFeature feature = missing.feature();
      if (!asked.contains(feature.member())) {
        BidRecord.Answer answer = new BidRecord.NotAsked(missing.reason());
        ofFeature(feature.type().name())
            .forEach(step -> rows.add(row(step, feature.member(), feature.type().name(), answer)));
      }
    }
    return List.copyOf(rows);
  }

  private List<BidRecord> answers(Proposal bid, String feature) {
    List<BidRecord> rows = new ArrayList<>();
    for (Optional<Step> step : ofFeature(feature)) {
      answer(bid, feature, step)
          .map(answer -> row(step, bid.member(), feature, answer))
          .ifPresent(rows::add);
    }
    return rows;
  }

  /** The steps of that feature, or none once. */
  private List<Optional<Step>> ofFeature(String feature) {
    List<Optional<Step>> steps =
        plan.stream()
            .filter(step -> step.feature().name().equals(feature))
            .map(Optional::of)
            .toList();
    return steps.isEmpty() ? List.of(Optional.empty()) : steps;
  }

  private Optional<Step> stepLike(StepKey key) {
    return plan.stream()
        .filter(
            step ->
                step.feature().name().equals(key.feature())
                    && step.bindings().equals(key.bindings()))
        .findFirst();
  }

  private static BidRecord row(
      Optional<Step> step, String member, String feature, BidRecord.Answer answer) {
    return new BidRecord(
        step.map(its -> OptionalInt.of(its.number())).orElseGet(OptionalInt::empty),
        member,
        feature,
        step.filter(its -> its.member().equals(member)).isPresent(),
        answer);
  }

  /** Nothing where the member has not priced the feature, or cannot do just this step. */
  private Optional<BidRecord.Answer> answer(Proposal bid, String feature, Optional<Step> step) {
    if (bid.refusal().isPresent()) {
      return Optional.of(new BidRecord.Refused(bid.refusal().get()));
    }
    return offers.getOrDefault(bid.member(), List.of()).stream()
        .filter(priced -> priced.type().name().equals(feature))
        .filter(priced -> step.filter(its -> isBarred(bid.member(), its)).isEmpty())
        .findFirst()
        .map(priced -> price(priced, step));
  }

  private boolean isBarred(String member, Step step) {
    return task.whyBarred()
        .containsKey(new StepKey(member, step.feature().name(), step.bindings()));
  }

  /**
   * Of the step that it got, what the plan counts on; what it would be for others, as things are.
   */
  private BidRecord.Priced price(PricedFeature priced, Optional<Step> step) {
    Map<String, Term> bindings = step.map(Step::bindings).orElse(Map.of());
    Optional<ExactPrice> exact = Optional.ofNullable(priced.exact().get(bindings));
    Kind stated = priced.price() instanceof Price.Stated ? Kind.STATED : Kind.AT_LEAST;
    Kind kind = exact.isPresent() ? Kind.EXACT : stated;
    Optional<Step> own = step.filter(its -> its.member().equals(priced.member()));
    if (own.isPresent()) {
      return priced(kind, own.get().cost(), own.get().seconds());
    }
    if (exact.isPresent()) {
      return priced(kind, exact.get().cost(), exact.get().seconds());
    }
    Map<String, Term> values =
        new StepKey(priced.member(), priced.type().name(), bindings).values();
    return new BidRecord.Priced(
        kind, number(cost(priced.price()), values), number(priced.type().seconds(), values));
  }

  private static BidRecord.Priced priced(Kind kind, double cost, double seconds) {
    return new BidRecord.Priced(kind, OptionalDouble.of(cost), OptionalDouble.of(seconds));
  }

  private static Expression cost(Price price) {
    return price instanceof Price.Stated stated ? stated.cost() : ((Price.Asked) price).atLeast();
  }

  private OptionalDouble number(Expression expression, Map<String, Term> values) {
    return values.keySet().containsAll(FreeVariables.of(expression))
        ? evaluation.number(expression, values)
        : OptionalDouble.empty();
  }
}
