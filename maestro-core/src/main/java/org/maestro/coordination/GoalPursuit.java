package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.maestro.knowledge.FeatureRun;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;
import org.maestro.planning.Plan;
import org.maestro.planning.PlanningResult;
import org.maestro.planning.PlanningTask;
import org.maestro.planning.PricedFeature;
import org.maestro.planning.Step;
import org.maestro.planning.StepKey;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * One goal on its way: plan, award, execute in partial order, compare what is known with what the
 * plan needs, plan again, confirm, end. The coordinator's thread only.
 */
final class GoalPursuit {
  private static final int MOST_PLANS = 60;

  private final String id;
  private final GoalRequest request;
  private final Ports ports;
  private final PlanCheck check;
  private final Roster roster;
  private final Occupancy occupancy;
  private final ExactPrices exactPrices;
  private final GoalStory story;
  private final Consumer<GoalOutcome> ended;
  private final Duration submittedAt;
  private final long submittedNanos = System.nanoTime();

  private final FailureMemory failures = new FailureMemory();
  private final StepsUnderway underway = new StepsUnderway();
  private final List<Crew.Performance> established = new ArrayList<>();
  private final Set<Integer> done = new LinkedHashSet<>();
  private GoalState state = GoalState.SUBMITTED;
  private String detail = "";
  private Optional<Plan> plan = Optional.empty();
  private List<PricedFeature> features = List.of();
  private Optional<Confirmation> confirmation = Optional.empty();
  private Optional<String> planAgain = Optional.empty();
  private boolean planning;
  private int plans;
  private int confirmingPlans;
  private int calls;
  private double decisionMillis;

  GoalPursuit(
      String id,
      GoalRequest request,
      Ports ports,
      Roster roster,
      Occupancy occupancy,
      ExactPrices exactPrices,
      Consumer<GoalOutcome> ended) {
    this.id = id;
    this.request = request;
    this.ports = ports;
    this.check = new PlanCheck(ports.planner());
    this.roster = roster;
    this.occupancy = occupancy;
    this.exactPrices = exactPrices;
    this.story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.ended = ended;
    this.submittedAt = ports.clock().now();
  }

  void start() {
    story.submitted(request);
    plan(Optional.empty());
  }

  GoalStatus status() {
    return new GoalStatus(id, SlPrinter.print(request.goal()), request.requester(), state, detail);
  }

  void cancel(String who) {
    if (!state.isFinal()) {
      end(GoalState.CANCELLED, false, Map.of(), List.of("Cancelled by " + who + "."));
    }
  }

  /** Something changed that no step of this goal reported. */
  void knowledgeChanged(KnowledgeBase.Change change) {
    if (!state.isFinal() && plan.isPresent() && !planning) {
      reconsider(() -> story.becauseOf(change));
    }
  }

  void memberLost(String member) {
    if (state.isFinal() || planning || plan.isEmpty()) {
      return;
    }
    if (remaining().stream().anyMatch(step -> step.member().equals(member))) {
      plan(Optional.of(member + " is lost (" + roster.absence(member) + ")"));
    }
  }

  /** A component became free, perhaps one that a step of this goal waits for. */
  void advance() {
    if (state.isFinal() || planning || plan.isEmpty()) {
      return;
    }
    List<Step> waiting = new ArrayList<>();
    for (Step step : new ExecutionOrder(plan.get()).startable(done)) {
      if (underway.contains(step)) {
        continue;
      }
      if (occupancy.isFree(step.member(), step.feature().occupies())
          && !underway.clashesWith(step)) {
        begin(step);
      } else {
        waiting.add(step);
      }
    }
    if (underway.isEmpty() && !waiting.isEmpty()) {
      Step first = waiting.get(0);
      become(GoalState.WAITING, occupancy.holders(first.member(), first.feature().occupies()));
    }
  }

  private void plan(Optional<String> why) {
    if (planning) {
      planAgain = why;
      return;
    }
    if (plans >= MOST_PLANS) {
      end(
          GoalState.FAILED,
          false,
          Map.of(),
          List.of("It was planned " + plans + " times without getting there; given up."));
      return;
    }
    planning = true;
    plans++;
    if (confirmation.isPresent()) {
      confirmingPlans++;
    }
    become(confirmation.isPresent() ? GoalState.CONFIRMING : GoalState.PLANNING, why.orElse(""));
    story.planning(plans, why);
    new PlanningRound(ports, exactPrices, subject(), barred(), this::presentFacts, this::planned)
        .start();
  }

  private void planned(PlanningRound.Ended round) {
    planning = false;
    if (state.isFinal()) {
      round.tender().award(Map.of());
      return;
    }
    features = round.features();
    story.bids(round.tender().bids(), round.questions());
    Optional<String> why = planAgain;
    planAgain = Optional.empty();
    if (why.isPresent() && !isStillGood(round.result())) {
      round.tender().award(Map.of());
      plan(why);
    } else if (round.result() instanceof PlanningResult.Found found) {
      adopt(found.plan(), round.tender());
    } else {
      round.tender().award(Map.of());
      noPlan(round.result());
    }
  }

  /** Something happened while it was planned: is the plan the right one all the same? */
  private boolean isStillGood(PlanningResult result) {
    return result instanceof PlanningResult.Found found
        && found.plan().steps().stream().allMatch(step -> roster.isPresent(step.member()))
        && check.isGood(plannedTask(), found.plan().steps());
  }

  private void adopt(Plan found, Market.Tender tender) {
    plan = Optional.of(found);
    done.clear();
    story.plan(plans, found, confirmation.isPresent());
    Map<String, List<Step>> parts = new TreeMap<>();
    found.steps().forEach(s -> parts.computeIfAbsent(s.member(), m -> new ArrayList<>()).add(s));
    tender.award(parts);
    underway.callOffAllBut(
        found.steps().stream().map(Step::key).collect(Collectors.toSet()), story::cancelled);
    if (confirmation.isEmpty()) {
      become(GoalState.RUNNING, "");
    }
    continueOrSettle();
  }

  private void noPlan(PlanningResult result) {
    plan = Optional.empty();
    if (!underway.isEmpty()) {
      become(GoalState.WAITING, "what is under way has to end first");
      return;
    }
    if (confirmation.isPresent() && holds().isPresent()) {
      story.unconfirmed();
      end(GoalState.ACHIEVED, false, holds().get().goalBinding(), List.of());
      return;
    }
    if (confirmation.isPresent()) {
      confirmation = Optional.empty();
      plan(Optional.of("it cannot be seen any more that the goal is reached"));
      return;
    }
    end(GoalState.FAILED, false, Map.of(), story.reasons(result));
  }

  private void begin(Step step) {
    calls++;
    if (calls == 1) {
      decisionMillis = (System.nanoTime() - submittedNanos) / 1e6;
    }
    if (state == GoalState.WAITING) {
      become(GoalState.RUNNING, "");
    }
    occupancy.take(step.member(), step.feature().occupies(), id);
    story.begun(step, plan.orElseThrow().steps().size());
    Snapshot before = ports.knowledge().snapshot();
    Map<String, Argument> arguments =
        new CallArguments(ports.knowledge().home(), before).of(step.feature(), step.bindings());
    Duration timeout = timeout(step);
    Crew.Performance[] performance = new Crew.Performance[1];
    performance[0] =
        ports
            .crew()
            .perform(
                new Crew.Order(id, step, arguments, timeout),
                report -> reported(step, before, report, performance[0]));
    underway.begun(step, before, performance[0]);
  }

  /** Sight is kept until the goal ends; one reading of a number is enough while it is valid. */
  private void keepOrEnd(Step step, Crew.Performance performance) {
    if (Sensing.isOfAtoms(step.feature().effect())) {
      established.add(performance);
    } else {
      performance.cancel();
    }
  }

  /** Thrice the expected time, and what the bus may take, which no fast clock makes shorter. */
  private Duration timeout(Step step) {
    double busMillis = 15_000 * Math.max(1, ports.clock().speed());
    return Duration.ofMillis((long) (step.seconds() * 3_000 + busMillis));
  }

  private void reported(
      Step step, Snapshot before, Crew.Report report, Crew.Performance performance) {
    boolean calledOff = underway.ended(step);
    occupancy.release(step.member(), step.feature().occupies(), id);
    exactPrices.forget(step.member());
    String factsBefore = factsUnder(step.key());
    KnowledgeBase.Change change = ports.knowledge().learn(run(step, before, report));
    if (state.isFinal()) {
      return;
    }
    if (report.succeeded()) {
      done(step);
      if (step.feature().continuous()) {
        keepOrEnd(step, performance);
      }
      story.done(step, change);
    } else if (!calledOff) {
      failures.note(step.key(), factsBefore);
      story.failed(step, report.problem().orElse("no reason given"), change);
    }
    if (planning) {
      planAgain = Optional.of("meanwhile " + story.becauseOf(change));
    } else if (plan.isEmpty()) {
      if (underway.isEmpty()) {
        plan(Optional.of("what was under way has ended"));
      }
    } else {
      reconsider(() -> report.problem().orElseGet(() -> story.becauseOf(change)));
    }
  }

  private void done(Step step) {
    plan.ifPresent(
        p ->
            p.steps().stream()
                .filter(s -> s.key().equals(step.key()) && !done.contains(s.number()))
                .findFirst()
                .ifPresent(s -> done.add(s.number())));
  }

  private FeatureRun run(Step step, Snapshot before, Crew.Report report) {
    Map<String, Term> bindings = new TreeMap<>(step.bindings());
    bindings.put("self", new Term.Name(step.member()));
    return new FeatureRun(
        step.member(),
        step.feature(),
        bindings,
        report.succeeded(),
        report.outputs(),
        report.refs(),
        Optional.of(before));
  }

  /** Is the rest of the plan still good, from what is known now? */
  private void reconsider(Supplier<String> why) {
    Optional<Plan> reached = holds();
    if (reached.isPresent()) {
      if (underway.isEmpty()) {
        settle(reached.get().goalBinding());
      }
      return;
    }
    List<Step> remaining = remaining();
    Optional<Step> unable =
        remaining.stream().filter(step -> !roster.isPresent(step.member())).findFirst();
    if (unable.isPresent()) {
      plan(Optional.of(roster.absence(unable.get().member())));
    } else if (remaining.isEmpty() || !check.isGood(plannedTask(), remaining)) {
      plan(Optional.of(why.get() + blockedStep(remaining)));
    } else {
      continueOrSettle();
    }
  }

  private String blockedStep(List<Step> remaining) {
    return check
        .blocked(plannedTask(), remaining)
        .map(
            step ->
                "; step %d (%s) is not possible so".formatted(step.number(), story.sentence(step)))
        .orElse("");
  }

  private void continueOrSettle() {
    if (plan.orElseThrow().steps().isEmpty() || remaining().isEmpty()) {
      Optional<Plan> reached = holds();
      if (reached.isPresent() && underway.isEmpty()) {
        settle(reached.get().goalBinding());
        return;
      }
    }
    advance();
  }

  /** The goal holds by what is known: end, or have it seen first. */
  private void settle(Map<String, Term> binding) {
    Optional<Confirmation> needed =
        Confirmation.needed(
            request.goal(),
            binding,
            ports.knowledge().snapshot(),
            ports.knowledge().home().vocabulary());
    if (needed.isEmpty()) {
      story.confirmed(request.goal(), binding);
      end(GoalState.ACHIEVED, true, binding, List.of());
    } else if (confirmation.isEmpty()) {
      confirmation = needed;
      plan = Optional.empty();
      story.confirming(needed.get().things());
      plan(Optional.empty());
    } else if (underway.isEmpty() && remaining().isEmpty()) {
      confirmation = needed;
      plan(Optional.of("it was not seen"));
    } else {
      advance();
    }
  }

  private void end(
      GoalState how, boolean confirmed, Map<String, Term> binding, List<String> reasons) {
    become(how, String.join(" ", reasons));
    underway.callOffAllBut(Set.of(), step -> {});
    established.forEach(Crew.Performance::cancel);
    GoalOutcome outcome =
        new GoalOutcome(
            id,
            SlPrinter.print(request.goal()),
            how,
            confirmed,
            binding,
            reasons,
            calls,
            Math.max(0, plans - confirmingPlans - 1),
            submittedAt,
            ports.clock().now(),
            decisionMillis);
    story.ended(outcome);
    ended.accept(outcome);
  }

  private Optional<Plan> holds() {
    return check.holds(
        new PlanningTask(
            ports.knowledge().home().vocabulary(),
            ports.knowledge().snapshot(),
            features,
            request.goal(),
            Set.of()));
  }

  private List<Step> remaining() {
    return plan.map(Plan::steps).orElse(List.of()).stream()
        .filter(step -> !done.contains(step.number()))
        .toList();
  }

  private PlanningRound.Subject subject() {
    return new PlanningRound.Subject(id, request.goal(), confirmation);
  }

  private PlanningTask plannedTask() {
    return new PlanningTask(
        subject().vocabulary(ports.knowledge().home()),
        presentFacts(),
        features,
        subject().planned(),
        barred());
  }

  private FactsBesideSteps presentFacts() {
    return underway.facts(ports.knowledge().snapshot(), ports.knowledge().home().vocabulary());
  }

  private Set<StepKey> barred() {
    return failures.barred(this::factsUnder);
  }

  private String factsUnder(StepKey key) {
    return Optional.ofNullable(ports.knowledge().home().devices().get(key.member())).stream()
        .flatMap(device -> device.features().stream())
        .filter(feature -> feature.name().equals(key.feature()))
        .findFirst()
        .map(
            feature -> {
              Map<String, Term> bindings = new TreeMap<>(key.bindings());
              bindings.put("self", new Term.Name(key.member()));
              return FactsUnder.of(feature.precondition(), bindings, ports.knowledge().snapshot());
            })
        .orElse("");
  }

  private void become(GoalState next, String why) {
    state = next;
    detail = why;
  }
}
