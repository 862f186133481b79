package org.maestro.members;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.HeldElsewhere;

/**
 * Which of several managers of goals may use which components of a member (ADE, 6; A94). The first
 * that uses one may, and goes on to until it gives it back; it is asked to when another wants it,
 * and decides by the standings of both goals when its own may do without. So where there is one
 * manager, or none wants what another has, nothing is said. Confined to one thread.
 */
public final class ComponentArbiter {
  /** Whose goal goes first: by rank and deadline, and then who has asked first. */
  private static final Comparator<Queued> ORDER =
      Comparator.<Queued, GoalPriority>comparing(
              queued -> {
                GoalPriority told = queued.want.standing();
                return new GoalPriority(told.priority(), told.grade(), told.deadline(), 0);
              })
          .thenComparingLong(queued -> queued.number);

  private final Managers managers;
  private final Map<String, HeldElsewhere> holders = new TreeMap<>();
  private final Map<Key, Queued> queue = new LinkedHashMap<>();
  private final Map<String, Integer> running = new TreeMap<>();
  private final Set<String> gone = new TreeSet<>();
  private long lastNumber;

  /** The way to the managers of goals, each known by its name. */
  public interface Managers {
    /**
     * It has what a goal of another wants, and is to give it back as soon as its own goals may do
     * without; said again when that goal goes earlier or later than before.
     */
    void askToYield(String holder, String by, ComponentWant want);

    /** What it was told to give back for that goal is wanted no more. */
    void wantedNoMore(String holder, String goalId);

    /** It has these components from now on. */
    void got(String manager, Set<String> components);
  }

  private record Key(String manager, String goalId) {}

  private static final class Queued {
    private final long number;
    private final Set<String> told = new TreeSet<>();
    private ComponentWant want;

    Queued(long number, ComponentWant want) {
      this.number = number;
      this.want = want;
    }
  }

  public ComponentArbiter(Managers managers) {
    this.managers = managers;
  }

  /**
   * Has a manager use components for a goal, unless another has one of them.
   *
   * @param brief what it does with them comes to an end by itself, and {@link #used} is told then
   * @return who has one; empty: all of them are the manager's now
   */
  public Optional<HeldElsewhere> use(
      String manager, String goalId, Set<String> components, boolean brief) {
    Optional<HeldElsewhere> other =
        components.stream()
            .sorted()
            .flatMap(component -> Optional.ofNullable(holders.get(component)).stream())
            .filter(holder -> !holder.manager().equals(manager))
            .findFirst();
    if (other.isEmpty()) {
      gone.remove(manager);
      hold(manager, goalId, components);
      if (brief) {
        components.forEach(component -> running.merge(component, 1, Integer::sum));
      }
    }
    return other;
  }

  /** What was begun with these components has come to its end; the manager has them still. */
  public void used(Set<String> components) {
    components.forEach(
        component -> running.computeIfPresent(component, (c, n) -> n > 1 ? n - 1 : null));
    if (!gone.isEmpty()) {
      holders.entrySet().removeIf(this::isLeftBehind);
      settle();
    }
  }

  /** Nobody has any more what a manager had that is gone, once nothing runs with it. */
  private boolean isLeftBehind(Map.Entry<String, HeldElsewhere> held) {
    return gone.contains(held.getValue().manager()) && !running.containsKey(held.getKey());
  }

  private void hold(String manager, String goalId, Set<String> components) {
    components.forEach(component -> holders.put(component, new HeldElsewhere(manager, goalId)));
  }

  /**
   * A manager wants components for a goal, all at once; in the place of what it wanted for it. Said
   * again, it is told to who has them again: who does not hear it is not there.
   */
  public void want(String manager, ComponentWant want) {
    gone.remove(manager);
    Queued queued =
        queue.computeIfAbsent(
            new Key(manager, want.goalId()), key -> new Queued(++lastNumber, want));
    queued.want = want;
    queued.told.clear();
    settle();
  }

  public void wantNoMore(String manager, String goalId) {
    Optional.ofNullable(queue.remove(new Key(manager, goalId))).ifPresent(this::isOver);
    settle();
  }

  private void isOver(Queued queued) {
    queued.told.forEach(holder -> managers.wantedNoMore(holder, queued.want.goalId()));
  }

  public void giveBack(String manager, Set<String> components) {
    components.forEach(
        component ->
            holders.computeIfPresent(
                component, (c, holder) -> holder.manager().equals(manager) ? null : holder));
    forgetToldTo(manager);
    settle();
  }

  /**
   * The manager is not there any more: it wants nothing, and has nothing but what is still at work
   * for it.
   */
  public void gone(String manager) {
    gone.add(manager);
    queue.keySet().removeIf(key -> key.manager().equals(manager));
    holders.entrySet().removeIf(this::isLeftBehind);
    forgetToldTo(manager);
    settle();
  }

  /** It is told anew when it has again what others want. */
  private void forgetToldTo(String manager) {
    queue.values().forEach(queued -> queued.told.remove(manager));
  }

  /** Whoever may have all that it wants gets it, and who has what others want is told. */
  private void settle() {
    Set<String> spokenFor = new HashSet<>();
    List<Map.Entry<Key, Queued>> inOrder = new ArrayList<>(queue.entrySet());
    inOrder.sort(Map.Entry.comparingByValue(ORDER));
    for (Map.Entry<Key, Queued> entry : inOrder) {
      String manager = entry.getKey().manager();
      Queued queued = entry.getValue();
      Set<String> components = queued.want.components();
      boolean mayHave =
          components.stream()
              .allMatch(
                  component ->
                      !spokenFor.contains(component)
                          && holder(component).map(manager::equals).orElse(true));
      if (mayHave) {
        queue.remove(entry.getKey());
        hold(manager, queued.want.goalId(), components);
        isOver(queued);
        managers.got(manager, components);
      }
      spokenFor.addAll(components);
    }
    queue.forEach((key, queued) -> tellHolders(key.manager(), queued));
  }

  private Optional<String> holder(String component) {
    return Optional.ofNullable(holders.get(component)).map(HeldElsewhere::manager);
  }

  private void tellHolders(String by, Queued queued) {
    Set<String> others =
        queued.want.components().stream()
            .flatMap(component -> holder(component).stream())
            .filter(holder -> !holder.equals(by))
            .collect(Collectors.toCollection(TreeSet::new));
    others.stream()
        .filter(queued.told::add)
        .forEach(holder -> managers.askToYield(holder, by, queued.want));
  }
}
