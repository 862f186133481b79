package org.maestro.coordination.contention;

import java.time.Duration;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.concurrent.Executor;
import java.util.stream.Collectors;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.rats.time.Clock;

/**
 * The goals of other managers that contend with those of this one for parts of members (ADE, 6;
 * A94). A member's agent lets one manager at a time use a part, the first that does, until that one
 * gives it back; so as long as nobody else wants it, nothing is said. What is known here is what
 * the agents have said: it may be old, and then a step is refused, or waits, and nothing is used
 * twice. The coordinator's thread only.
 */
public final class OtherManagers {
  /**
   * So often what is wanted is said again, as an agent may have taken this manager for gone, or
   * does not know yet that another is. A goal that keeps something, and waits for what another
   * manager has, then stands back for one of another manager that goes first and waits for it: they
   * may be in a circle that no manager sees the whole of.
   */
  private static final Duration PATIENCE = Duration.ofSeconds(10);

  private final ActiveGoals activeGoals;
  private final ActionDispatcher agents;
  private final Clock clock;
  private final Executor owner;
  private final Map<String, Guest> guests = new TreeMap<>();
  private Map<Asked, ComponentWant> asked = new LinkedHashMap<>();
  private boolean isLookedAfter;
  private boolean wereThere;

  private record Asked(String goal, String member) {}

  OtherManagers(ActiveGoals activeGoals, ActionDispatcher agents, Clock clock, Executor owner) {
    this.activeGoals = activeGoals;
    this.agents = agents;
    this.clock = clock;
    this.owner = owner;
  }

  private Leases leases() {
    return activeGoals.leases();
  }

  Optional<Contender> find(String goal) {
    return Optional.ofNullable(guests.get(goal));
  }

  /** Whether a goal of another manager has ever contended with these: it may at any time again. */
  boolean areThere() {
    return wereThere;
  }

  boolean isWaiting(String goal) {
    return Optional.ofNullable(guests.get(goal)).filter(Guest::isWaiting).isPresent();
  }

  /** A step was refused, as another manager has what it needs. */
  public void have(String member, Set<String> components, HeldElsewhere by) {
    guest(by.goalId()).has(member, resources(member, components));
    isElsewhere(by.goalId(), member, resources(member, components));
    retire();
  }

  /** A goal of another manager wants what this one may have. */
  public void want(ComponentWant want) {
    activeGoals.run(
        () -> {
          Guest guest = guest(want.goalId());
          leases().rank(guest.id(), standing(want));
          guest.wants(want);
          guest.advance();
          retire();
        });
  }

  /** It comes behind the goals that are there already, and before those that come. */
  private GoalPriority standing(ComponentWant want) {
    GoalPriority told = want.standing();
    return new GoalPriority(
        told.priority(), told.grade(), told.deadline(), leases().latestNumber());
  }

  public void wantNoMore(String goal, String member) {
    activeGoals.run(
        () -> {
          Optional.ofNullable(guests.get(goal)).ifPresent(guest -> guest.wantsNoMore(member));
          retire();
        });
  }

  /** The member's agent has these given to this manager. */
  public void gave(String member, Set<String> components) {
    activeGoals.run(() -> free(resources(member, components)));
  }

  /** Nobody knows any more who has what of the member: its agent is another one, or not there. */
  public void forget(String member) {
    asked.keySet().removeIf(key -> key.member().equals(member));
    guests.values().forEach(guest -> guest.wantsNoMore(member));
    free(
        guests.keySet().stream()
            .flatMap(guest -> leases().kept(guest).stream())
            .filter(resource -> resource.owner().equals(member))
            .collect(Collectors.toSet()));
  }

  private void free(Set<Resource> resources) {
    List.copyOf(guests.values()).forEach(guest -> guest.hasNoMore(resources));
    retire();
  }

  private Guest guest(String goal) {
    wereThere = true;
    return guests.computeIfAbsent(
        goal,
        id -> {
          leases().enter(id, new GoalPriority(0, Optional.empty(), leases().latestNumber()));
          return new Guest(id, activeGoals, this);
        });
  }

  void giveBack(String to, ComponentWant want) {
    agents.giveBack(want.member(), want.components());
    isElsewhere(to, want.member(), want.resources());
  }

  /** It is out of this manager's hands; what else wants it here is told of elsewhere. */
  private void isElsewhere(String holder, String member, Set<Resource> resources) {
    guests.values().stream()
        .filter(guest -> !guest.id().equals(holder) && guest.wantsOneOf(resources))
        .forEach(guest -> guest.wantsNoMore(member));
  }

  private void retire() {
    for (Guest guest : List.copyOf(guests.values())) {
      if (!guest.isWaiting() && leases().kept(guest.id()).isEmpty()) {
        guests.remove(guest.id());
        leases().leave(guest.id());
      }
    }
  }

  private static Set<Resource> resources(String member, Set<String> components) {
    return components.stream()
        .map(component -> Resource.component(member, component))
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * Who goes first, in the same words for all managers: the numbers of their goals say nothing of
   * those of others.
   */
  Comparator<Contender> order() {
    return Comparator.<Contender, GoalPriority>comparing(
            one -> {
              GoalPriority own = leases().ownStanding(one.id());
              return new GoalPriority(own.priority(), own.grade(), own.deadline(), 0);
            })
        .thenComparing(Contender::id);
  }

  /** Has the members' agents told for what these goals wait that others have. */
  void tellWhatIsWanted() {
    if (guests.isEmpty() && asked.isEmpty()) {
      return;
    }
    lookAfter();
    Map<Asked, ComponentWant> now = new LinkedHashMap<>();
    for (WaitsFor edge : leases().graph()) {
      boolean isOfAnother =
          leases().keeper(edge.resource()).filter(guests::containsKey).isPresent()
              && !guests.containsKey(edge.goalId());
      if (isOfAnother) {
        String member = edge.resource().owner();
        now.put(new Asked(edge.goalId(), member), want(edge.goalId(), member));
      }
    }
    Map<Asked, ComponentWant> before = asked;
    asked = now;
    before.keySet().stream()
        .filter(key -> !now.containsKey(key))
        .forEach(key -> agents.wantNoMore(key.goal(), key.member()));
    now.forEach(
        (key, want) -> {
          if (!want.equals(before.get(key))) {
            agents.want(want);
          }
        });
  }

  private ComponentWant want(String goal, String member) {
    Set<String> components =
        leases().awaited(goal).stream()
            .filter(resource -> resource.kind() == Resource.Kind.COMPONENT)
            .filter(resource -> resource.owner().equals(member))
            .map(Resource::part)
            .collect(Collectors.toSet());
    return new ComponentWant(goal, leases().standing(goal), member, components);
  }

  private void lookAfter() {
    if (!isLookedAfter) {
      isLookedAfter = true;
      clock.schedule(
          PATIENCE, "other managers", () -> owner.execute(() -> activeGoals.run(this::look)));
    }
  }

  private void look() {
    isLookedAfter = false;
    asked.values().forEach(agents::want);
    for (Guest guest : List.copyOf(guests.values())) {
      leases().waitsOf(guest.id()).stream()
          .flatMap(edge -> leases().keeper(edge.resource()).stream())
          .distinct()
          .flatMap(keeper -> activeGoals.find(keeper).stream())
          .filter(keeper -> order().compare(guest, keeper) < 0)
          .filter(keeper -> keeper.underway().isEmpty() && isStuck(keeper.id()))
          .forEach(keeper -> keeper.stepBackFor(guest.id()));
    }
  }

  /** It waits, and for something that another manager has. */
  private boolean isStuck(String goal) {
    return asked.keySet().stream().anyMatch(key -> key.goal().equals(goal));
  }
}
