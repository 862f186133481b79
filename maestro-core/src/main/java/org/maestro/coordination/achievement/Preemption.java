package org.maestro.coordination.achievement;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.ResourceClaims;
import org.maestro.coordination.contention.StandingBack;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;

/**
 * Whose turn it is, seen from one goal: it waits for its turn, gives way at a safe point to one of
 * higher priority, and steps back when goals wait for each other in a circle.
 *
 * <p>A safe point is where no step uses what the other wants, and no member carries something for
 * this goal. No step under way is ever taken out of a member's hand.
 */
final class Preemption {
  private final GoalLife life;
  private final GoalStory story;
  private final ActiveGoals activeGoals;
  private final ResourceClaims resourceClaims;
  private final StepsUnderway underway;
  private final StandingBack standingBack;
  private Optional<String> asked = Optional.empty();
  private Set<Resource> told = Set.of();

  Preemption(
      GoalLife life,
      GoalStory story,
      ActiveGoals activeGoals,
      ResourceClaims resourceClaims,
      StepsUnderway underway) {
    this.life = life;
    this.story = story;
    this.activeGoals = activeGoals;
    this.standingBack = new StandingBack(life.id(), activeGoals);
    this.resourceClaims = resourceClaims;
    this.underway = underway;
  }

  private String id() {
    return life.id();
  }

  /** Whether it has stepped back for one that is not over yet, or has not got its way yet. */
  boolean isAfterAnother() {
    return standingBack.isSo();
  }

  /** Another plan is made, which may wait for something else. */
  void forget() {
    standingBack.forget();
    activeGoals.leases().stopWaiting(id());
  }

  /** It cannot have what it wants now; until then it keeps nothing that others could use. */
  void await(Set<Resource> wanted, List<WaitsFor> obstacles) {
    wait(GoalPhase.WAITING_FOR_TURN, wanted, obstacles);
    if (!life.phase().isResting()) {
      life.become(GoalPhase.HALTING);
    }
    if (underway.isEmpty()) {
      resourceClaims.letGo();
    }
    activeGoals.askForWay(id(), obstacles);
    activeGoals.breakCircle(id());
  }

  /** It has all components, and a step waits for a thing in use, or a fact that another needs. */
  void awaitForStep(List<WaitsFor> obstacles) {
    wait(
        GoalPhase.WAITING_FOR_STEP,
        obstacles.stream().map(WaitsFor::resource).collect(Collectors.toCollection(TreeSet::new)),
        obstacles);
    if (underway.isEmpty() && obstacles.stream().anyMatch(Preemption::mayTakeLong)) {
      resourceClaims.letGo();
    }
    activeGoals.breakCircle(id());
  }

  /** A door is free as soon as a step ends; what others count on, they may need for long. */
  private static boolean mayTakeLong(WaitsFor obstacle) {
    return obstacle.resource().kind() == Resource.Kind.FACT;
  }

  private void wait(GoalPhase waiting, Set<Resource> wanted, List<WaitsFor> obstacles) {
    activeGoals.leases().waitFor(id(), wanted, obstacles);
    if (underway.isEmpty() && life.state() != GoalState.SUSPENDED) {
      String why = inWords(obstacles);
      life.becomeIfNew(waiting, why);
      Set<Resource> resources =
          obstacles.stream().map(WaitsFor::resource).collect(Collectors.toSet());
      if (!told.equals(resources)) {
        told = resources;
        story.waits(obstacles);
      }
    }
  }

  private static String inWords(List<WaitsFor> obstacles) {
    return obstacles.stream().map(WaitsFor::inWords).distinct().collect(Collectors.joining(", "));
  }

  /** It waits for nothing and keeps nothing, for as long as it is not worth it. */
  void rest() {
    forget();
    resourceClaims.letGo();
  }

  /** What it waited for is there. */
  void came(boolean confirming) {
    forget();
    told = Set.of();
    if (life.state() == GoalState.SUSPENDED) {
      story.goesOn();
    }
    life.become(confirming ? GoalPhase.LOOKING : GoalPhase.RUNNING, "");
  }

  void giveWay(String to) {
    asked = Optional.of(to);
    activeGoals.run(() -> activeGoals.find(id()).ifPresent(ActiveGoal::advance));
  }

  /** Whether it stands back now, as it was asked to, and may without harm. */
  boolean givesWay(Set<Resource> wanted) {
    Optional<String> to = asked.filter(activeGoals::contends);
    List<WaitsFor> contested =
        to.stream()
            .flatMap(other -> activeGoals.leases().waitsOf(other).stream())
            .filter(edge -> edge.holder().equals(id()))
            .toList();
    if (contested.isEmpty()) {
      asked = Optional.empty();
      return false;
    }
    if (resourceClaims.needsNow(contested.stream().map(WaitsFor::resource).toList())) {
      return false;
    }
    asked = Optional.empty();
    standingBack.untilWayOf(to.get());
    List<WaitsFor> edges = new ArrayList<>();
    contested.forEach(edge -> edges.add(new WaitsFor(id(), edge.resource(), to.get())));
    edges.add(new WaitsFor(id(), Resource.endOf(to.get()), to.get()));
    suspend(
        wanted,
        edges,
        to.get() + " goes first with " + things(contested) + activeGoals.whyFirst(to.get(), id()));
    resourceClaims.letGo();
    return true;
  }

  private static String things(Collection<WaitsFor> edges) {
    return edges.stream()
        .map(edge -> edge.resource().inWords())
        .distinct()
        .collect(Collectors.joining(" and "));
  }

  private void suspend(Set<Resource> wanted, List<WaitsFor> edges, String why) {
    activeGoals.leases().waitFor(id(), wanted, edges);
    life.become(GoalPhase.SUSPENDED, why);
    story.suspended(why);
  }

  /** Until the other is over. */
  void standBackFor(String other) {
    standingBack.untilEndOf(other);
    suspend(
        Set.of(),
        List.of(new WaitsFor(id(), Resource.endOf(other), other)),
        other + " goes first" + activeGoals.whyFirst(other, id()));
    resourceClaims.letGo();
  }

  void stepBackFor(String other) {
    resourceClaims.letGoOfAll();
    standBackFor(other);
  }
}
