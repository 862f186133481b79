package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.ResourceClaims;
import org.maestro.coordination.story.GoalStory;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.Step;

/**
 * Makes one plan for a goal beside others: the cheapest of all, unless it would have to wait for
 * what others have, and a plan with what is free costs less than that one and the waiting.
 */
final class PlanMaking {
  private final String goalId;
  private final Ports ports;
  private final Roster roster;
  private final ExactPrices exactPrices;
  private final GoalMonitor monitor;
  private final ActiveGoals activeGoals;
  private final ResourceClaims resourceClaims;
  private final GoalStory story;
  private final Consumer<PlanningRound.Ended> then;

  PlanMaking(
      String goalId,
      Ports ports,
      Roster roster,
      ExactPrices exactPrices,
      GoalMonitor monitor,
      ActiveGoals activeGoals,
      ResourceClaims resourceClaims,
      GoalStory story,
      Consumer<PlanningRound.Ended> then) {
    this.goalId = goalId;
    this.ports = ports;
    this.roster = roster;
    this.exactPrices = exactPrices;
    this.monitor = monitor;
    this.activeGoals = activeGoals;
    this.resourceClaims = resourceClaims;
    this.story = story;
    this.then = then;
  }

  void start() {
    round(Set.of(), this::first);
  }

  private void round(Set<String> without, Consumer<PlanningRound.Ended> made) {
    new PlanningRound(
            ports,
            roster,
            exactPrices,
            activeGoals.experience(),
            monitor.subject(),
            monitor.barred(),
            without,
            monitor::factsForPlans,
            made)
        .start();
  }

  private void first(PlanningRound.Ended round) {
    if (!(round.result() instanceof PlanningResult.Found found)) {
      then.accept(round);
      return;
    }
    List<WaitsFor> taken = resourceClaims.obstaclesToPlan(found.plan().steps());
    Set<String> busy = activeGoals.busyMembers(goalId);
    double wait = activeGoals.secondsUntilFree(goalId, taken);
    if (wait > 0 && hasSubstitute(found.plan(), busy)) {
      round(busy, second -> choose(found.plan(), round, second, wait));
    } else {
      then.accept(round);
    }
  }

  /** Whether for each busy member of the plan somebody free offers the same features. */
  private boolean hasSubstitute(Plan plan, Set<String> busy) {
    return plan.steps().stream()
        .filter(step -> busy.contains(step.member()))
        .allMatch(step -> isOfferedBesides(step, busy));
  }

  private boolean isOfferedBesides(Step step, Set<String> busy) {
    return ports.knowledge().home().devices().values().stream()
        .filter(device -> !busy.contains(device.id()))
        .flatMap(device -> device.features().stream())
        .anyMatch(feature -> feature.name().equals(step.feature().name()));
  }

  private void choose(
      Plan cheapest, PlanningRound.Ended first, PlanningRound.Ended second, double wait) {
    if (second.result() instanceof PlanningResult.Found free
        && free.plan().cost() < cheapest.cost() + wait) {
      first.tender().reject();
      story.takesWhatIsFree(members(cheapest), wait, cheapest.cost(), free.plan().cost());
      then.accept(second);
    } else {
      second.tender().reject();
      then.accept(first);
    }
  }

  private Set<String> members(Plan plan) {
    Set<String> members = new TreeSet<>(activeGoals.busyMembers(goalId));
    Set<String> used = new TreeSet<>();
    plan.steps().forEach(step -> used.add(step.member()));
    members.retainAll(used);
    return members;
  }
}
