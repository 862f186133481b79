package org.maestro.coordination.achievement;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.facts.FactsUnder;
import org.maestro.coordination.facts.Sensing;
import org.maestro.coordination.lessons.FailureMemory;
import org.maestro.coordination.lessons.Insistence;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Effect;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The lessons of one goal: what failed, was in vain, comes too late or would end what others keep,
 * and so is left alone as things are. The coordinator's thread only.
 */
final class GoalLessons {
  /** What nobody can see counts as not so as soon as it is not known any more. */
  private static final Set<PlanningResult.Obstacle.Kind> LEFT_OPEN =
      Set.of(PlanningResult.Obstacle.Kind.UNKNOWN, PlanningResult.Obstacle.Kind.FACT);

  private final String goalId;
  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final FailureMemory failures;
  private final SearchLog searches;
  private final VainDeeds deeds;
  private final Map<StepKey, String> leftAlone = new LinkedHashMap<>();
  private final Map<StepKey, String> tooLate = new LinkedHashMap<>();
  private final Set<Step> inVain = new LinkedHashSet<>();
  private boolean hasTriedVainDeedsAgain;

  /** What became of it when a step failed, nobody knew. */
  private final FactFilter leftOpen;

  GoalLessons(String goalId, Ports ports, ActiveGoals activeGoals, VainDeeds deeds) {
    this.goalId = goalId;
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.deeds = deeds;
    this.failures = new FailureMemory(goalId, ports.journal(), this::tries);
    this.searches = new SearchLog(goalId, ports.journal());
    this.leftOpen = new FactFilter(vocabulary());
  }

  /** What was learnt before a restart. */
  void takeUp(Recovery.GoalMemory former) {
    failures.takeUp(former.failures());
    searches.takeUp(former.looks());
  }

  /** Returns what is known only now of the conditions on which the step's member insists. */
  List<Insistence> failed(StepEnd ended, String problem) {
    StepKey step = ended.step().key();
    List<FeatureRun.Learnt> refs = ended.report().refs();
    Set<Formula.Atom> taught = Insistence.facts(refs);
    Snapshot now = ports.knowledge().snapshot();
    String after = FactsUnder.with(factsUnder(step), taught, now);
    List<Insistence> news =
        describedFeature(step)
            .map(type -> activeGoals.experience().refused(step, type, refs, now))
            .orElse(List.of());
    if (tries(step) == 1 && ended.report().begun() && ended.report().refusal().isEmpty()) {
      deeds.spent(step, after);
    }
    failures.note(
        step,
        FactsUnder.asTaught(ended.factsBefore(), after, taught),
        Sentences.withoutFullStop(problem),
        refs,
        ended.report().refusal().filter(refusal -> !isKnownToLackSomething(step, now)));
    List<String> lost =
        ended.change().facts().stream().filter(fact -> fact.startsWith("(unknown ")).toList();
    leftOpen.addAll(FactFilter.of(lost, vocabulary()));
    return news;
  }

  /** Then plans bring that about first, and need not leave the step alone. */
  private boolean isKnownToLackSomething(StepKey step, Snapshot now) {
    return describedFeature(step)
        .map(type -> activeGoals.experience().condition(step.member(), type))
        .map(condition -> new Evaluation(now).truth(condition, step.values()))
        .filter(Truth.FALSE::equals)
        .isPresent();
  }

  /** Returns whether any barred step had no last chance before. */
  boolean giveLastChances() {
    boolean any = failures.giveLastChances(this::factsUnder) || !tooLate.isEmpty();
    tooLate.clear();
    if (!hasTriedVainDeedsAgain && deeds.giveLastChances()) {
      hasTriedVainDeedsAgain = true;
      any = true;
    }
    return any;
  }

  /** The member offers to do the feature: what failed before says nothing any more. */
  void offersAgain(String member, String feature) {
    failures.pardon(member, feature);
    tooLate
        .keySet()
        .removeIf(step -> step.member().equals(member) && step.feature().equals(feature));
  }

  /** Its member takes so much longer than it said that others are preferred as long as any can. */
  void tooLate(Step step, String why) {
    tooLate.put(step.key(), why);
  }

  /**
   * Why the step is not to be begun, as it came to nothing so often; plans do without it as long as
   * nothing changes.
   */
  Optional<String> isInVain(Step step) {
    Optional<String> why = deeds.leftAlone(step, ports.knowledge().snapshot());
    why.ifPresent(reason -> inVain.add(step));
    return why;
  }

  /** What was said to be done again and again, and came to nothing; one sentence each. */
  List<String> reasonsOfVainDeeds() {
    Snapshot now = ports.knowledge().snapshot();
    return inVain.stream()
        .flatMap(step -> deeds.leftAlone(step, now).stream())
        .distinct()
        .map(why -> why + ".")
        .toList();
  }

  /** What is known has changed. */
  void knowledgeChanged() {
    deeds.look(ports.knowledge().snapshot());
  }

  /** The goal is reached: what was done was not in vain. */
  void reached() {
    deeds.reached();
  }

  /** The step would end what another goal keeps for good; as long as it does, nobody does it. */
  void leaveAlone(Step step, String keeper) {
    leftAlone.put(step.key(), keeper);
  }

  /** Those whose goals are left alone though this one may go before them, now or before long. */
  List<ActiveGoal> keepersThatMayTurn() {
    return leftAlone.values().stream()
        .distinct()
        .filter(keeper -> activeGoals.mayTurn(goalId, keeper))
        .flatMap(keeper -> activeGoals.find(keeper).stream())
        .filter(ActiveGoal::isHolding)
        .toList();
  }

  /** What these keep is not left alone any more. */
  void leaveAloneNoMore(ActiveGoal keeper) {
    leftAlone.values().removeIf(keeper.id()::equals);
  }

  List<String> reasonsOfLeavingAlone() {
    return leftAlone.values().stream()
        .distinct()
        .flatMap(keeper -> activeGoals.find(keeper).stream())
        .filter(ActiveGoal::isHolding)
        .map(
            keeper ->
                "It would end what %s keeps, %s; cancel that one, or give this one a higher priority."
                    .formatted(keeper.id(), keeper.status().goal()))
        .toList();
  }

  /**
   * Steps that failed too often with facts as they are, and those that would end what others keep,
   * each with its reason.
   *
   * @param isConfirming how often it is looked whether it is done, is counted by itself
   */
  Map<StepKey, String> barred(boolean isConfirming) {
    leftAlone
        .values()
        .removeIf(keeper -> activeGoals.find(keeper).filter(ActiveGoal::isHolding).isEmpty());
    Map<StepKey, String> barred = new LinkedHashMap<>(deeds.spent(this::factsUnder));
    barred.putAll(failures.barred(this::factsUnder));
    barred.putAll(tooLate);
    Snapshot now = ports.knowledge().snapshot();
    inVain.removeIf(step -> deeds.leftAlone(step, now).isEmpty());
    inVain.forEach(
        step -> deeds.leftAlone(step, now).ifPresent(why -> barred.put(step.key(), why)));
    leftAlone.forEach((step, keeper) -> barred.put(step, "it would end what " + keeper + " keeps"));
    if (!isConfirming) {
      searches
          .spent()
          .forEach(step -> barred.put(step, "it was in vain " + SearchLog.ROUNDS + " times"));
    }
    return barred;
  }

  /**
   * Whether there would be a plan if somebody did what was refused now, or failed, or if that were
   * so which a step that failed left open.
   */
  boolean restsOnRefusals(PlanningResult result, List<PricedFeature> features) {
    return result instanceof PlanningResult.Impossible impossible
        && (impossible.explanation().obstacles().stream().anyMatch(this::isOrWouldDoInstead)
            || features.stream().anyMatch(this::isInsistedOn));
  }

  /** The result, in which what a failure left open is called unknown, and not otherwise. */
  PlanningResult asLeftOpen(PlanningResult result) {
    if (!(result instanceof PlanningResult.Impossible impossible)) {
      return result;
    }
    return new PlanningResult.Impossible(
        new PlanningResult.Explanation(
            impossible.explanation().obstacles().stream()
                .map(o -> isLeftOpen(o) ? o.with(PlanningResult.Obstacle.Kind.UNKNOWN) : o)
                .toList(),
            impossible.explanation().proven()));
  }

  private boolean isOrWouldDoInstead(PlanningResult.Obstacle obstacle) {
    return mayBeOvercome(obstacle)
        || obstacle.cures().stream()
            .anyMatch(c -> c.conditions().stream().allMatch(this::mayBeOvercome));
  }

  private boolean mayBeOvercome(PlanningResult.Obstacle obstacle) {
    return isRefusal(obstacle) || isLeftOpen(obstacle) || isOfUselessResults(obstacle);
  }

  /** That it insists on the same elsewhere is not what it said. */
  private boolean isInsistedOn(PricedFeature feature) {
    return activeGoals.experience().isInsistedOn(feature.member(), feature.type().name());
  }

  private boolean isOfUselessResults(PlanningResult.Obstacle obstacle) {
    return obstacle.kind() == PlanningResult.Obstacle.Kind.MEMBER
        && activeGoals.experience().isDoubted(obstacle.condition());
  }

  private boolean isLeftOpen(PlanningResult.Obstacle obstacle) {
    return LEFT_OPEN.contains(obstacle.kind()) && leftOpen.speaksOf(obstacle.condition());
  }

  private boolean isRefusal(PlanningResult.Obstacle obstacle) {
    return obstacle.kind() == PlanningResult.Obstacle.Kind.STEP
        && obstacle.subject().filter(step -> !leftAlone.containsKey(step)).isPresent();
  }

  /**
   * A step succeeded, and what it found is known. What is said to be done again and again, and has
   * to be, counts as a failure from the second time on; what may be tried only once, at once.
   *
   * @param factsBefore under its precondition
   * @param begun what was known when it was begun
   */
  void done(Step step, String factsBefore, Snapshot begun, Map<String, Term> outputs) {
    if (!Sensing.isIn(step.feature().effect())) {
      deeds.said(step, begun);
      if (isForOnce(step)) {
        deeds.spent(step.key(), factsBefore);
      } else if (deeds.isVain(step.key(), factsBefore)) {
        failures.note(
            step.key(),
            factsBefore,
            "it was said to be done, and is needed again",
            List.of(),
            Optional.empty());
      }
    }
    searches.done(
        step,
        outputs,
        ports.knowledge().snapshot(),
        ports.clock().now(),
        ports.knowledge().home().vocabulary());
  }

  /** What it adds to a number may have to be added again. */
  private boolean isForOnce(Step step) {
    return tries(step.key()) == 1
        && !Sensing.any(step.feature().effect(), Effect.Change.class::isInstance);
  }

  /** How many places were looked at in vain, each counted once. */
  int placesLookedAt() {
    return searches.places();
  }

  /** The facts on which the step's precondition rests, as text to be compared. */
  String factsUnder(StepKey key) {
    return describedFeature(key)
        .map(
            feature -> {
              Snapshot now = ports.knowledge().snapshot();
              return FactsUnder.with(
                  FactsUnder.of(feature.precondition(), key.values(), now),
                  failures.taught(key),
                  now);
            })
        .orElse("");
  }

  private Optional<FeatureType> describedFeature(StepKey key) {
    return Optional.ofNullable(ports.knowledge().home().devices().get(key.member())).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(key.feature()))
        .findFirst();
  }

  private int tries(StepKey key) {
    return describedFeature(key).map(FeatureType::reliability).orElse(Reliability.USUAL).tries();
  }

  SearchLog searches() {
    return searches;
  }

  private Vocabulary vocabulary() {
    return ports.knowledge().home().vocabulary();
  }
}
