package org.maestro.coordination.pursuit;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.Contention;
import org.maestro.coordination.contention.Rivals;
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
  private final Outlook outlook;
  private final Rivals rivals;
  private final Contention contention;
  private final GoalStory story;
  private final Consumer<PlanningRound.Ended> then;

  PlanMaking(
      String goalId,
      Ports ports,
      Roster roster,
      ExactPrices exactPrices,
      Outlook outlook,
      Rivals rivals,
      Contention contention,
      GoalStory story,
      Consumer<PlanningRound.Ended> then) {
    this.goalId = goalId;
    this.ports = ports;
    this.roster = roster;
    this.exactPrices = exactPrices;
    this.outlook = outlook;
    this.rivals = rivals;
    this.contention = contention;
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
            rivals.experience(),
            outlook.subject(),
            outlook.barred(),
            without,
            outlook.isTrusting(),
            outlook::factsForPlans,
            made)
        .start();
  }

  private void first(PlanningRound.Ended round) {
    if (!(round.result() instanceof PlanningResult.Found found)) {
      then.accept(round);
      return;
    }
    List<WaitsFor> taken = contention.obstaclesToPlan(found.plan().steps());
    Set<String> busy = rivals.busyMembers(goalId);
    double wait = rivals.secondsUntilFree(goalId, taken);
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
      first.tender().award(Map.of());
      story.takesWhatIsFree(members(cheapest), wait, cheapest.cost(), free.plan().cost());
      then.accept(second);
    } else {
      second.tender().award(Map.of());
      then.accept(first);
    }
  }

  private Set<String> members(Plan plan) {
    Set<String> members = new TreeSet<>(rivals.busyMembers(goalId));
    Set<String> used = new TreeSet<>();
    plan.steps().forEach(step -> used.add(step.member()));
    members.retainAll(used);
    return members;
  }
}
