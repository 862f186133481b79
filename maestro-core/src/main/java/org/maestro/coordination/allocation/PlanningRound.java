package org.maestro.coordination.allocation;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.coordination.api.BidRecord;
import org.maestro.coordination.api.CallArguments;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.coordination.facts.EpistemicGoal;
import org.maestro.coordination.facts.Relevance;
import org.maestro.coordination.facts.Sensing;
import org.maestro.coordination.lessons.Experience;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.OpenPrice;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.api.Unavailable;
import org.maestro.sl.Effect;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One round from goal to plan: candidate features, a contract-net round for their prices, the
 * cheapest plan, exact prices for those of its steps whose price was a lower bound, the plan found
 * again, until the cheapest plan has exact prices.
 */
public final class PlanningRound {

  /**
   * The goal of the round, as it is planned for: in a confirming round, it is extended by what has
   * to be seen; in a round that finds out, to have seen what decides it will do.
   */
  public record Subject(
      String goalId, Formula goal, Optional<Confirmation> confirmation, PlanPurpose purpose) {
    private boolean isFindingOut() {
      return purpose == PlanPurpose.FIND_OUT;
    }

    public Formula planned(Home home) {
      return isFindingOut()
          ? EpistemicGoal.goal(goal, home.vocabulary())
          : confirmation.map(c -> c.goal(goal)).orElse(goal);
    }

    Formula relevant(Home home) {
      boolean ofPlaces = confirmation.filter(c -> !c.things().isEmpty()).isPresent();
      return isFindingOut() || ofPlaces ? EpistemicGoal.relevant(goal, home.vocabulary()) : goal;
    }

    /** Whether it matters who has seen what. */
    boolean isOfSeeing() {
      return isFindingOut() || confirmation.isPresent();
    }

    /** The candidates that may take part: who only looks puts nothing where it is looked for. */
    Map<String, List<String>> candidates(Home home) {
      Map<String, List<String>> candidates = Relevance.candidates(relevant(home), home);
      if (purpose == PlanPurpose.LOOK && goal instanceof Formula.Atom sought) {
        candidates.replaceAll(
            (member, features) ->
                Objects.requireNonNull(home.devices().get(member)).features().stream()
                    .filter(type -> features.contains(type.name()))
                    .filter(type -> Sensing.helpsToLook(type, sought))
                    .map(FeatureType::name)
                    .toList());
        candidates.values().removeIf(List::isEmpty);
      }
      return candidates;
    }

    public Vocabulary vocabulary(Home home) {
      return isOfSeeing() ? Confirmation.extend(home.vocabulary()) : home.vocabulary();
    }

    PricedFeature feature(PricedFeature priced, Home home) {
      return isOfSeeing() ? Confirmation.extend(priced, home.vocabulary()) : priced;
    }
  }

  /**
   * The outcome of the round.
   *
   * @param questions exact prices asked
   * @param unpriced sentences about exact prices that were not given or cannot be, the member's
   *     name first
   * @param task what was planned last: with all prices that are known, and who could not be counted
   *     on
   */
  public record Ended(
      CandidateProposals tender,
      PlanningResult result,
      List<PricedFeature> features,
      int questions,
      List<String> unpriced,
      PlanningTask task) {

    /** What came of asking each member, step by step. */
    public List<BidRecord> answers() {
      List<Step> steps =
          result instanceof PlanningResult.Found found ? found.plan().steps() : List.of();
      return new AnswersToCalls(task, steps).of(tender);
    }

    /** A sentence about those who might have helped, and named no price. */
    public Optional<String> notCountedOn() {
      List<String> others = new ArrayList<>();
      for (Proposal bid : tender.bids()) {
        bid.refusal().ifPresent(reason -> others.add(bid.member() + " (" + reason + ")"));
      }
      others.addAll(unpriced);
      return others.isEmpty()
          ? Optional.empty()
          : Optional.of("Not counted on: " + String.join("; ", others) + ".");
    }
  }

  private static final Logger LOG = LoggerFactory.getLogger(PlanningRound.class);

  private final Ports ports;
  private final Roster roster;
  private final ExactPrices exactPrices;
  private final Experience experience;
  private final Subject subject;
  private final Map<StepKey, String> barred;
  private final Set<String> without;
  private final Supplier<? extends Facts> facts;
  private final Consumer<Ended> then;
  private final CandidateProposals proposals;
  private final PriceQuestions priceQuestions = new PriceQuestions();
  private final PriceInquiry inquiry;

  /**
   * @param without members that are left out on trial: when there is no plan without them, nobody
   *     is asked why
   */
  public PlanningRound(
      Ports ports,
      Roster roster,
      ExactPrices exactPrices,
      Experience experience,
      Subject subject,
      Map<StepKey, String> barred,
      Set<String> without,
      Supplier<? extends Facts> facts,
      Consumer<Ended> then) {
    this.ports = ports;
    this.roster = roster;
    this.exactPrices = exactPrices;
    this.experience = experience;
    this.subject = subject;
    this.barred = barred;
    this.without = without;
    this.facts = facts;
    this.then = then;
    Map<String, List<String>> candidates = candidates(ports.knowledge().home());
    candidates.keySet().removeAll(without);
    this.proposals = new CandidateProposals(candidates, roster);
    this.inquiry = new PriceInquiry(subject.goalId(), ports, exactPrices, priceQuestions, facts);
  }

  public void start() {
    Set<String> first = proposals.atFirst();
    if (first.isEmpty()) {
      solve();
    } else {
      call(first, this::solve);
    }
  }

  /** Nobody, where what has to be seen is seen by no feature of anybody. */
  private Map<String, List<String>> candidates(Home home) {
    Map<String, List<String>> candidates = subject.candidates(home);
    if (subject.confirmation().isPresent() && !subject.isFindingOut()) {
      List<Effect> effects =
          home.devices().values().stream()
              .flatMap(device -> device.features().stream())
              .map(FeatureType::effect)
              .toList();
      return subject.confirmation().get().canBeSeenBy(effects) ? candidates : new TreeMap<>();
    }
    return candidates;
  }

  private void call(Set<String> members, Runnable answered) {
    ports
        .contractNet()
        .callForPrices(
            new CallForPrices(subject.goalId(), subject.goal(), proposals.featuresOf(members)),
            round -> {
              proposals.add(members, round);
              answered.run();
            });
  }

  private List<PricedFeature> features(Home home) {
    return priceQuestions.reckoned(
        experience.reliable(proposals.features(home, exactPrices)).stream()
            .map(feature -> subject.feature(feature, home))
            .toList());
  }

  private void solve() {
    Home home = ports.knowledge().home();
    Snapshot snapshot = ports.knowledge().snapshot();
    List<PricedFeature> features = features(home);
    Set<StepKey> unusable = new HashSet<>(barred.keySet());
    unusable.addAll(inquiry.unusable());
    Map<StepKey, String> reasons = new HashMap<>(barred);
    reasons.putAll(inquiry.reasons());
    PlanningTask task =
        new PlanningTask(
                subject.vocabulary(home), facts.get(), features, subject.planned(home), unusable)
            .withUnavailable(unavailable(home), reasons);
    boolean explaining = proposals.allCalled() && !isTrial() && !subject.isOfSeeing();
    ports
        .thinking()
        .think(() -> planned(task, explaining), result -> planned(task, result, home, snapshot));
  }

  private boolean isTrial() {
    return !without.isEmpty();
  }

  /** Nothing is to be planned again when those who are called now only say what they describe. */
  private void planned(PlanningTask task, PlanningResult result, Home home, Snapshot snapshot) {
    boolean failedTrial = isTrial() && !(result instanceof PlanningResult.Found);
    Set<String> wanted = failedTrial ? Set.of() : proposals.wantedFor(result);
    if (wanted.isEmpty()) {
      solved(task, result, home, snapshot);
      return;
    }
    call(
        wanted,
        () -> {
          if (result instanceof PlanningResult.Found && task.features().equals(features(home))) {
            solved(task, result, home, snapshot);
          } else {
            solve();
          }
        });
  }

  /** A fault of the planner's own ends the goal with a reason; it must not leave it without end. */
  private PlanningResult planned(PlanningTask task, boolean explaining) {
    try {
      return explaining ? ports.planner().plan(task) : ports.planner().solve(task);
    } catch (RuntimeException e) {
      LOG.error("Planning for {} failed", subject.goalId(), e);
      return new PlanningResult.GaveUp("The planner failed; its log says why.");
    }
  }

  private void solved(PlanningTask task, PlanningResult result, Home home, Snapshot snapshot) {
    List<OpenPrice> open =
        result instanceof PlanningResult.Found found ? priceQuestions.next(found) : List.of();
    if (open.isEmpty()) {
      if (!(result instanceof PlanningResult.Found) && inquiry.mayAskAgain()) {
        solve();
      } else {
        PlanningResult end =
            result instanceof PlanningResult.Found found ? priceQuestions.proven(found) : result;
        then.accept(
            new Ended(proposals, end, task.features(), inquiry.asked(), inquiry.unpriced(), task));
      }
      return;
    }
    Set<StepKey> trusted =
        subject.purpose() == PlanPurpose.REACH_TRUSTING
            ? afterDeeds(((PlanningResult.Found) result).plan())
            : Set.of();
    inquiry.ask(open, trusted, new CallArguments(home, snapshot), this::solve);
  }

  private static Set<StepKey> afterDeeds(Plan plan) {
    Set<StepKey> after = new HashSet<>();
    for (Step step : plan.steps()) {
      if (isAfterDeeds(step, plan.steps())) {
        after.add(step.key());
      }
    }
    return after;
  }

  private static boolean isAfterDeeds(Step step, List<Step> plan) {
    return plan.stream()
        .filter(earlier -> step.after().contains(earlier.number()))
        .anyMatch(
            earlier -> !Sensing.isIn(earlier.feature().effect()) || isAfterDeeds(earlier, plan));
  }

  /** Features that would count if their members were there, or took part. */
  private List<Unavailable> unavailable(Home home) {
    List<Unavailable> unavailable = new ArrayList<>();
    for (Unavailable left : experience.unreliable(proposals.features(home, exactPrices))) {
      unavailable.add(new Unavailable(subject.feature(left.feature(), home), left.reason()));
    }
    for (String member : proposals.missing()) {
      Device device = home.devices().get(member);
      if (device != null) {
        String reason = absence(member);
        device.features().stream()
            .filter(type -> proposals.candidateFeatures(member).contains(type.name()))
            .map(type -> new PricedFeature(member, type, type.cost(), Map.of()))
            .forEach(f -> unavailable.add(new Unavailable(subject.feature(f, home), reason)));
      }
    }
    return unavailable;
  }

  private String absence(String member) {
    if (!roster.isPresent(member)) {
      return roster.absence(member, ports.clock().now());
    }
    return proposals
        .bid(member)
        .map(b -> "it refuses: " + b.refusal().orElse("no reason given"))
        .orElse("it did not answer");
  }
}
