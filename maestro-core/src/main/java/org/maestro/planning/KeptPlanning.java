package org.maestro.planning;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.grounding.GroundingCache;
import org.maestro.planning.optimal.KeptGround;
import org.maestro.planning.problem.Execution;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;

/**
 * The groundwork for one goal, kept for when it is planned for again: feature instances, and the
 * last plan with the problem that it solves. For one thread at a time.
 */
final class KeptPlanning {
  private static final double SAME_COST = 1e-6;

  /** Some take many megabytes. */
  private static final int MOST_GROUNDS = 2;

  /** How many times as much a plan may cost at first than what was searched in vain. */
  private static final double MORE = 1.2;

  /**
   * A plan that is proven to be the cheapest.
   *
   * @param operators those of the plan, applicable one after the other in the problem
   * @param features those that were there when it was found
   */
  private record Proven(
      Plan plan,
      List<Operator> operators,
      GroundProblem problem,
      PlanningTask task,
      Set<Integer> features) {}

  private final GroundingCache work;
  private final Grounder grounder;
  private PlanningTask task;

  /** The last change of facts that is known here. */
  private long seen;

  /** What is or was otherwise than when the plan was proven. */
  private final Set<Object> changed = new LinkedHashSet<>();

  private Optional<Proven> proven = Optional.empty();

  /** The last plan, where it is not proven to be the cheapest. */
  private Optional<Plan> unproven = Optional.empty();

  /** Of the last plan, proven or not. */
  private double lastCost;

  /** Within which the last plan that is not proven was found. */
  private double lastBudget;

  /** Whether the last plan was to find something; then the next one probably is as well. */
  private boolean isSeeking;

  /** For those who were there at different times, the newest first. */
  private final Deque<KeptGround> grounds = new ArrayDeque<>();

  /**
   * @param work that was made for the task, or went over to it
   */
  KeptPlanning(GroundingCache work, PlanningTask task) {
    this.work = work;
    this.task = task;
    this.seen = work.changes().last();
    this.grounder = new Grounder(work, task);
  }

  /** Goes over to another task for the same goal; the groundwork has gone there before. */
  void renew(PlanningTask next) {
    Optional<Set<Object>> since = work.changes().after(seen);
    if (since.isEmpty()) {
      proven = Optional.empty();
      grounds.clear();
    }
    since.orElse(Set.of()).stream().filter(this::matters).forEach(changed::add);
    seen = work.changes().last();
    grounder.renew(next);
    task = next;
  }

  /** What was never looked at, other goals asked for. */
  private boolean matters(Object asked) {
    return grounder.variable(asked).filter(v -> !grounder.hasConsulted(v)).isEmpty();
  }

  /** As {@link OptimalPlanner#solve}. */
  PlanningResult solve(int mostStates) {
    Optional<Plan> still = proven.flatMap(this::stillCheapest);
    if (still.isPresent()) {
      return new PlanningResult.Found(still.get(), OptionalDouble.empty(), contenders());
    }
    Optional<Plan> rest = proven.map(Proven::plan).or(() -> unproven).flatMap(this::rest);
    if (!changed.isEmpty()) {
      grounds.clear();
    }
    Effort effort = Effort.forBestPlan(mostStates);
    for (KeptGround ground : grounds) {
      Optional<PlanningResult.Found> again = ground.cheapest(task, grounder, effort);
      if (again.isPresent()) {
        return keeping(again.get(), rest, ground.problem());
      }
    }
    BudgetedSearch search = new BudgetedSearch(task, grounder, mostStates, true);
    PlanningResult result = atLeastAsGood(search.run(firstBudget(rest)), rest);
    changed.clear();
    proven = Optional.empty();
    unproven = Optional.empty();
    lastCost = result instanceof PlanningResult.Found found ? found.plan().cost() : 0;
    isSeeking = result instanceof PlanningResult.Found found && !found.plan().searches().isEmpty();
    if (result instanceof PlanningResult.Found found && isProof(found, search)) {
      search.kept(found.plan().cost()).ifPresent(grounds::addFirst);
      if (grounds.size() > MOST_GROUNDS) {
        grounds.removeLast();
      }
      return keeping(found, rest, search.solved().orElseThrow().placed());
    }
    if (result instanceof PlanningResult.Found found && mayBeBettered(found)) {
      unproven = Optional.of(found.plan());
      lastBudget = search.lastBudget();
    }
    return result;
  }

  private double firstBudget(Optional<Plan> rest) {
    if (isSeeking) {
      return 0;
    }
    return unproven.isPresent()
        ? Math.min(lastBudget, lastCost)
        : rest.map(this::withRest).orElseGet(this::withoutRest);
  }

  /**
   * The rest of the old plan is within the budget that it costs. Where that is far more than it was
   * to cost, as when its prices were asked for, others that nobody asked are likely to cost less.
   */
  private double withRest(Plan rest) {
    return Math.min(rest.cost(), MORE * lastCost);
  }

  /** A plan that is not proven may be dearer than the rest of the last one. */
  private PlanningResult atLeastAsGood(PlanningResult result, Optional<Plan> rest) {
    return result instanceof PlanningResult.Found found && mayBeBettered(found)
        ? rest.filter(old -> old.cost() <= found.plan().cost() + SAME_COST)
            .map(found::with)
            .orElse(found)
        : result;
  }

  private boolean mayBeBettered(PlanningResult.Found found) {
    return task.objective() == Objective.CHEAPEST
        && found.atLeast().isPresent()
        && found.plan().searches().isEmpty();
  }

  /** Where the old plan is of no use, one is likely to cost some more than what was searched. */
  private double withoutRest() {
    return grounds.isEmpty() || grounds.getFirst().beyond() == Double.POSITIVE_INFINITY
        ? proven.map(before -> before.plan().cost()).orElse(lastCost)
        : MORE * grounds.getFirst().beyond();
  }

  /** The rest of the old plan stays the plan while none is cheaper. */
  private PlanningResult keeping(
      PlanningResult.Found found, Optional<Plan> rest, GroundProblem problem) {
    Plan plan =
        rest.filter(old -> old.cost() <= found.plan().cost() + SAME_COST).orElse(found.plan());
    proven = proven(plan, problem);
    return found.with(plan);
  }

  /** A plan that weighs where to look is not the cheapest of those that count on finding. */
  private boolean isProof(PlanningResult.Found found, BudgetedSearch search) {
    return task.objective() == Objective.CHEAPEST
        && found.atLeast().isEmpty()
        && search.solved().filter(problem -> Sought.of(problem).isEmpty()).isPresent();
  }

  private Optional<Proven> proven(Plan plan, GroundProblem problem) {
    List<StepKey> steps = plan.steps().stream().map(Step::key).toList();
    return Execution.operators(problem.operators(), problem.initial(), steps)
        .map(operators -> new Proven(plan, operators, problem, task, grounder.featuresThere()));
  }

  /**
   * The rest of the plan after steps that did what was expected of them, with nothing else changed:
   * whoever left and whatever is barred, no rest can be cheaper than that of the cheapest plan.
   */
  private Optional<Plan> stillCheapest(Proven before) {
    if (!before.features().containsAll(grounder.featuresThere())
        || !task.barred().containsAll(before.task().barred())) {
      return Optional.empty();
    }
    GroundProblem problem = before.problem().placed();
    Set<Object> variables = new LinkedHashSet<>(problem.variables());
    variables.addAll(problem.numbers());
    for (Object asked : changed) {
      if (grounder.variable(asked).filter(variables::contains).isEmpty()) {
        return Optional.empty();
      }
    }
    State state = problem.initial();
    for (int done = 0; done <= before.operators().size(); done++) {
      if (isNow(state, problem)) {
        List<Step> steps = before.plan().steps();
        double left = steps.subList(done, steps.size()).stream().mapToDouble(Step::cost).sum();
        return OptimalPlanner.revalidate(grounder, steps.subList(done, steps.size()))
            .filter(rest -> rest.cost() <= left + SAME_COST);
      }
      if (done < before.operators().size()) {
        state = Successors.after(before.operators().get(done), state);
      }
    }
    return Optional.empty();
  }

  private static boolean isNow(State state, GroundProblem problem) {
    return problem.variables().stream().allMatch(v -> state.code(v) == v.initialCode())
        && problem.numbers().stream()
            .allMatch(n -> Double.compare(state.number(n), n.initial()) == 0);
  }

  /** The shortest end of the plan that reaches the goal from where things are now. */
  private Optional<Plan> rest(Plan before) {
    List<Step> steps = before.steps();
    for (int from = steps.size(); from >= 0; from--) {
      Optional<Plan> rest = OptimalPlanner.revalidate(grounder, steps.subList(from, steps.size()));
      if (rest.isPresent()) {
        return rest;
      }
    }
    return Optional.empty();
  }

  private Set<String> contenders() {
    Set<String> members = new LinkedHashSet<>();
    Set<String> there = new LinkedHashSet<>();
    task.features().forEach(feature -> there.add(feature.member()));
    proven.ifPresent(
        before -> {
          members.addAll(before.plan().members());
          before.problem().operators().forEach(o -> members.add(o.feature().member()));
        });
    members.retainAll(there);
    return members;
  }
}
