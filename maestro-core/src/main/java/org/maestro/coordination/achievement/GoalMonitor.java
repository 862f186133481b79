package org.maestro.coordination.achievement;

import java.time.Duration;
import java.time.Instant;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.facts.Assured;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.coordination.facts.EpistemicGoal;
import org.maestro.coordination.facts.FactsMaskedByRunningSteps;
import org.maestro.coordination.facts.KnowledgeVersion;
import org.maestro.coordination.facts.PlanCheck;
import org.maestro.coordination.facts.ReckonedFromPlaces;
import org.maestro.coordination.facts.Relevance;
import org.maestro.coordination.facts.ReplanTriggers;
import org.maestro.coordination.facts.Symbols;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.OpenChoice;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Effect;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The known present as it looks to one goal: whether it holds, and whether steps lead to it. */
final class GoalMonitor {
  /** Each look in vain takes one; more looks than places and things together are of no use. */
  private static final int MOST_FINDING_OUT = 20;

  /**
   * What was observed longer ago is observed again before the goal is called reached: as long as a
   * thing in view stays in view without a word. At more than wall speed messages take longer.
   */
  private static final Duration LATELY = Duration.ofSeconds(2);

  private final String goalId;
  private final Formula goal;
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final PlanCheck check;
  private final GoalLessons lessons;
  private List<PricedFeature> features = List.of();
  private Optional<Confirmation> confirmation = Optional.empty();
  private Instant confirmedSince = Instant.MIN;
  private final PlanPurpose usually;
  private PlanPurpose purpose;
  private PlanPurpose nextPurpose;
  private int timesFoundOut;
  private Set<Formula.Atom> soughtBeside = Set.of();
  private final Set<Formula.Atom> leftOut = new HashSet<>();

  /**
   * @param usually what plans for the goal are made for
   */
  GoalMonitor(
      String goalId,
      GoalRequest request,
      Ports ports,
      ActiveGoals activeGoals,
      VainDeeds deeds,
      PlanPurpose usually) {
    this.goalId = goalId;
    this.goal = Assured.of(request.goal(), ports.knowledge().home().vocabulary());
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.lessons = new GoalLessons(goalId, ports, activeGoals, deeds);
    this.check = new PlanCheck(ports.planner());
    this.usually = usually;
    this.purpose = usually;
    this.nextPurpose = usually;
  }

  String goalId() {
    return goalId;
  }

  GoalLessons lessons() {
    return lessons;
  }

  /** Features at the prices of the latest round. */
  void offered(List<PricedFeature> offered) {
    features = offered;
  }

  boolean isConfirming() {
    return confirmation.isPresent();
  }

  /** What has to be seen from now on, besides the goal itself. */
  void confirm(Optional<Confirmation> needed) {
    if (needed.isPresent() && confirmation.isEmpty()) {
      confirmedSince = lately();
    }
    confirmation = needed;
  }

  private Instant lately() {
    return ports.clock().instant().minus(ports.clock().ofWallAtLeast(LATELY));
  }

  /** What would have to be seen if the goal were called reached with these values. */
  Optional<Confirmation> toBeSeen(Map<String, Term> binding) {
    return Confirmation.needed(
        goal,
        binding,
        ports.knowledge().snapshot(),
        ports.knowledge().home(),
        isConfirming() ? confirmedSince : lately());
  }

  /** The goal itself, by what is known now, without what would have to be seen. */
  Optional<Plan> holds() {
    return check.holds(
        new PlanningTask(
            ports.knowledge().home().vocabulary(),
            ports.knowledge().snapshot(),
            features,
            goal,
            Set.of()));
  }

  /** Whether the steps lead to the goal, at no higher cost than planned. */
  boolean isGood(List<Step> steps) {
    return check.isGood(task(), steps);
  }

  /** The first of the steps that cannot be done any more. */
  Optional<Step> blocked(List<Step> steps) {
    return check.blocked(task(), steps);
  }

  /** What must not change for these steps to remain the right ones. */
  ReplanTriggers concern(List<Step> steps) {
    return new ReplanTriggers(goal, steps, ports.knowledge().home().vocabulary(), presentFacts());
  }

  PlanningRound.Subject subject() {
    return new PlanningRound.Subject(goalId, goal, confirmation, purpose);
  }

  /** Whether the member offers anything that could be part of a plan for the goal. */
  boolean isCandidate(String member) {
    return Relevance.candidates(goal, ports.knowledge().home()).containsKey(member);
  }

  /** Features that could take part, if it were known what their parameters may be. */
  List<OpenChoice> openChoices() {
    List<OpenChoice> open = OpenChoice.of(ports.knowledge().home());
    if (open.isEmpty()) {
      return open;
    }
    Map<String, List<String>> candidates = Relevance.candidates(goal, ports.knowledge().home());
    return open.stream()
        .filter(one -> candidates.getOrDefault(one.device(), List.of()).contains(one.feature()))
        .toList();
  }

  /** Whether looks may show that it is so already, though nobody can make it so. */
  boolean canFindOut() {
    return timesFoundOut < MOST_FINDING_OUT
        && EpistemicGoal.helps(goal, ports.knowledge().snapshot(), vocabulary());
  }

  /** The next plan is to show whether it is so already. */
  void findOut() {
    timesFoundOut++;
    nextPurpose = PlanPurpose.FIND_OUT;
  }

  boolean isFindingOut() {
    return purpose == PlanPurpose.FIND_OUT;
  }

  /** A plan is to be made now. */
  void planBegins() {
    leftOut.clear();
    purpose = nextPurpose;
    nextPurpose = usually;
  }

  /**
   * In the next plan, a step that its member declines now counts as possible after steps that
   * change the world before it: they may clear its way.
   */
  void trustEarlierSteps() {
    nextPurpose = PlanPurpose.REACH_TRUSTING;
  }

  Facts factsForPlans() {
    FactsMaskedByRunningSteps present = presentFacts();
    present.addSoughtBeside(soughtBeside);
    leftOut.addAll(soughtBeside);
    return isFindingOut()
        ? EpistemicGoal.withWhatIsSeen(present, ports.knowledge().snapshot())
        : present;
  }

  /**
   * Whether the last plan counted something as not so, since looks beside it were to show that, and
   * they have not.
   */
  boolean hasLeftOutWhatMayBe() {
    Snapshot now = ports.knowledge().snapshot();
    return leftOut.stream().anyMatch(sought -> now.truth(sought) != Truth.FALSE);
  }

  /** Plans look elsewhere, as long as it is looked beside them whether these are so. */
  void isSoughtBeside(Set<Formula.Atom> sought) {
    soughtBeside = Set.copyOf(sought);
  }

  /** Whether the goal speaks of what the effect may change. */
  boolean isAbout(Effect effect) {
    Set<String> names = Symbols.withDerivations(goal, vocabulary());
    return Symbols.changedBy(effect).stream().anyMatch(names::contains);
  }

  private Vocabulary vocabulary() {
    return ports.knowledge().home().vocabulary();
  }

  /** What is known now. */
  KnowledgeVersion look() {
    return new KnowledgeVersion(ports.knowledge().snapshot().version(), presentFacts());
  }

  FactsMaskedByRunningSteps presentFacts() {
    return activeGoals.factsBesideSteps(
        goalId, ports.knowledge().snapshot(), ports.knowledge().home().vocabulary());
  }

  /** The steps that are left alone as things are, each with its reason. */
  Map<StepKey, String> barred() {
    return lessons.barred(isConfirming());
  }

  boolean restsOnRefusals(PlanningResult result) {
    return lessons.restsOnRefusals(result, features);
  }

  /**
   * Whether the goal speaks of what changes with the places of things, though no effect says so.
   */
  boolean restsOnPlaces() {
    return new ReckonedFromPlaces(vocabulary()).isIn(goal, ports.knowledge().snapshot());
  }

  /** What became of the goal's searches. */
  SearchReview searchReview(Roster roster) {
    return SearchReview.of(goal, ports, roster, features, barred().keySet(), lessons.searches());
  }

  private PlanningTask task() {
    return new PlanningTask(
        subject().vocabulary(ports.knowledge().home()),
        factsForPlans(),
        features,
        subject().planned(ports.knowledge().home()),
        barred().keySet());
  }
}
