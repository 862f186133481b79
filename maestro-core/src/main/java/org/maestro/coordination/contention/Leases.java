package org.maestro.coordination.contention;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;

/**
 * The mutual exclusion of goals and of steps: who has what, and who waits for what. A goal keeps
 * components of members over many steps, and gets all that it asks for at once or nothing, so that
 * goals that have nothing yet never wait for each other in a circle. A step has what it uses, and
 * the individuals it claims, while it runs. What is held for steps of a script, these steps may
 * keep and use, each for itself, and nobody else.
 */
public final class Leases {
  private final Map<String, GoalPriority> standings = new LinkedHashMap<>();
  private final Map<Resource, String> keepers = new TreeMap<>();
  private final Map<Resource, String> holders = new TreeMap<>();
  private final Map<Resource, Run> runs = new TreeMap<>();
  private final Map<String, Wait> waits = new LinkedHashMap<>();
  private final Consumer<String> wake;

  private record Run(String goal, String member) {}

  private record Wait(Set<Resource> wanted, List<WaitsFor> edges) {}

  /**
   * @param wake told the goals that may go on, first who goes first; is to look at them later, not
   *     inside the call
   */
  Leases(Consumer<String> wake) {
    this.wake = wake;
  }

  void enter(String goal, GoalPriority standing) {
    standings.put(goal, standing);
  }

  /** The goal goes earlier or later than before: what waits for it, or it waits for, may change. */
  void rank(String goal, GoalPriority standing) {
    standings.put(goal, standing);
    wakeThose(edge -> edge.holder().equals(goal));
    wake.accept(goal);
  }

  /** The goal is over: it waits for nothing and keeps nothing; its steps may still be running. */
  void leave(String goal) {
    stopWaiting(goal);
    letGo(goal, kept(goal));
    release(goal);
    standings.remove(goal);
    moved(goal);
  }

  /** What the goal keeps. */
  Set<Resource> kept(String goal) {
    return keepers.entrySet().stream()
        .filter(e -> e.getValue().equals(goal))
        .map(Map.Entry::getKey)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** What keeps the goal from having all these; empty when it may keep them. */
  public List<WaitsFor> obstaclesToKeep(String goal, Set<Resource> wanted) {
    Set<Resource> mine = kept(goal);
    List<WaitsFor> obstacles = new ArrayList<>();
    for (Resource resource : new TreeSet<>(wanted)) {
      if (!mine.contains(resource)) {
        holder(goal, resource)
            .or(() -> mine.isEmpty() ? firstInQueue(goal, resource) : Optional.empty())
            .ifPresent(holder -> obstacles.add(new WaitsFor(goal, resource, holder)));
      }
    }
    return obstacles;
  }

  private Optional<String> holder(String goal, Resource resource) {
    return Optional.ofNullable(keepers.get(resource))
        .or(() -> Optional.ofNullable(runs.get(resource)).map(Run::goal))
        .filter(holder -> !isOne(holder, goal))
        .or(
            () ->
                Optional.ofNullable(holders.get(resource)).filter(holder -> !isOne(holder, goal)));
  }

  /** Whether both are the same, or one is pursued for a step of the other. */
  private static boolean isOne(String one, String another) {
    return one.equals(another) || GoalId.isOfStep(one, another) || GoalId.isOfStep(another, one);
  }

  /** Nobody is overtaken by one who comes later and has nothing yet. */
  private Optional<String> firstInQueue(String goal, Resource resource) {
    return before(goal, resource).stream()
        .min(Comparator.comparing(other -> standingWithout(other, goal)));
  }

  /** The highest number of a goal that is here. */
  int latestNumber() {
    return standings.values().stream().mapToInt(GoalPriority::number).max().orElse(0);
  }

  /** Who keeps it; nobody while it is held for steps, or a step runs with it. */
  Optional<String> keeper(Resource resource) {
    return Optional.ofNullable(keepers.get(resource));
  }

  /** What the goal waits for; empty when it does not. */
  Set<Resource> awaited(String goal) {
    return Optional.ofNullable(waits.get(goal)).map(Wait::wanted).orElse(Set.of());
  }

  /** The goal has it, whoever kept it before: he will find that out when he looks. */
  void taken(String goal, Set<Resource> resources) {
    resources.forEach(resource -> keepers.put(resource, goal));
  }

  /** To be called only when nothing stands in the way. */
  void keep(String goal, Set<Resource> wanted) {
    wanted.forEach(resource -> keepers.put(resource, goal));
  }

  /**
   * The same for steps of a script that are goals within this one: what they let go stays held. To
   * be called only when nothing stands in the way.
   */
  public void hold(String goal, Set<Resource> wanted) {
    wanted.forEach(resource -> holders.putIfAbsent(resource, goal));
    kept(goal).forEach(resource -> keepers.remove(resource, goal));
  }

  /** What is held for the goal's steps is so no more; what one of them keeps it keeps. */
  public void release(String goal) {
    Set<Resource> free =
        holders.entrySet().stream()
            .filter(e -> e.getValue().equals(goal))
            .map(Map.Entry::getKey)
            .collect(Collectors.toSet());
    holders.keySet().removeAll(free);
    wakeFor(free);
  }

  /** Whether a step within the goal keeps or uses one of them now. */
  public boolean isUsedWithin(String goal, Set<Resource> resources) {
    return resources.stream()
        .flatMap(
            resource ->
                Stream.concat(
                    Stream.ofNullable(keepers.get(resource)),
                    Stream.ofNullable(runs.get(resource)).map(Run::goal)))
        .anyMatch(user -> GoalId.isOfStep(user, goal));
  }

  void letGo(String goal, Collection<Resource> resources) {
    Set<Resource> free = new HashSet<>();
    for (Resource resource : resources) {
      if (keepers.remove(resource, goal)) {
        free.add(resource);
      }
    }
    wakeFor(free);
  }

  /**
   * What keeps a step of the goal from running: steps of others that still run with what it uses,
   * and any step that has what it claims.
   */
  List<WaitsFor> obstaclesToRun(String goal, Set<Resource> wanted) {
    List<WaitsFor> obstacles = new ArrayList<>();
    for (Resource resource : new TreeSet<>(wanted)) {
      runs.forEach(
          (taken, run) -> {
            boolean another = !run.goal().equals(goal);
            if (taken.equals(resource) && (another || resource.kind() == Resource.Kind.INDIVIDUAL)
                || another && isPartOf(taken, resource)) {
              obstacles.add(new WaitsFor(goal, resource, run.goal()));
            }
          });
    }
    return obstacles;
  }

  /** Whoever passes a door claims it against its drive, and the other way round. */
  private static boolean isPartOf(Resource a, Resource b) {
    return a.kind() != b.kind() && a.owner().equals(b.owner());
  }

  void run(String goal, String member, Set<Resource> resources) {
    resources.forEach(resource -> runs.put(resource, new Run(goal, member)));
  }

  /** What the member's step had is free, unless it was lost before and another has it now. */
  void ended(String goal, String member, Set<Resource> resources) {
    Set<Resource> free = new HashSet<>();
    for (Resource resource : resources) {
      if (runs.remove(resource, new Run(goal, member))) {
        free.add(resource);
      }
    }
    wakeFor(free);
  }

  /** The member is dead: whatever its steps had is free. */
  public void lost(String member) {
    Set<Resource> free =
        runs.entrySet().stream()
            .filter(e -> e.getValue().member().equals(member))
            .map(Map.Entry::getKey)
            .collect(Collectors.toSet());
    runs.keySet().removeAll(free);
    wakeFor(free);
  }

  /**
   * The goal cannot go on as long as this is so.
   *
   * @param wanted what it stands in the queue for
   */
  public void waitFor(String goal, Set<Resource> wanted, List<WaitsFor> edges) {
    Wait before = waits.put(goal, new Wait(Set.copyOf(wanted), List.copyOf(edges)));
    if (before != null && wanted.isEmpty()) {
      leavesQueues(goal, before.wanted());
    }
  }

  /** Whoever stood behind it there may be the first now. */
  private void leavesQueues(String goal, Set<Resource> queues) {
    wakeThose(edge -> edge.holder().equals(goal) && queues.contains(edge.resource()));
  }

  public void stopWaiting(String goal) {
    Wait wait = waits.remove(goal);
    if (wait != null) {
      wakeThose(edge -> edge.holder().equals(goal) || wait.wanted().contains(edge.resource()));
    }
  }

  /** The goal counts on something else now. */
  void moved(String goal) {
    wakeThose(
        edge ->
            edge.holder().equals(goal)
                && (edge.resource().kind() == Resource.Kind.FACT
                    || edge.resource().kind() == Resource.Kind.END));
  }

  private void wakeFor(Set<Resource> free) {
    if (!free.isEmpty()) {
      wakeThose(
          edge ->
              free.contains(edge.resource())
                  || free.stream().anyMatch(resource -> isPartOf(resource, edge.resource())));
    }
  }

  private void wakeThose(Predicate<WaitsFor> concerned) {
    waits.entrySet().stream()
        .filter(e -> e.getValue().edges().stream().anyMatch(concerned))
        .map(Map.Entry::getKey)
        .sorted(Comparator.comparing(this::standing))
        .toList()
        .forEach(wake);
  }

  /** The wait-for graph: first the edges of who waits longest. */
  public List<WaitsFor> graph() {
    return waits.values().stream().flatMap(wait -> wait.edges().stream()).toList();
  }

  public List<WaitsFor> waitsOf(String goal) {
    return Optional.ofNullable(waits.get(goal)).map(Wait::edges).orElse(List.of());
  }

  /** The goals that stand in the queue for the resource before this one. */
  List<String> before(String goal, Resource resource) {
    GoalPriority mine = standing(goal);
    return waits.entrySet().stream()
        .filter(e -> !isOne(e.getKey(), goal) && e.getValue().wanted().contains(resource))
        .map(Map.Entry::getKey)
        .filter(other -> standingWithout(other, goal).compareTo(mine) < 0)
        .toList();
  }

  /** Components that the goal could not have now. */
  Set<Resource> takenFrom(String goal) {
    Set<Resource> taken = new TreeSet<>(keepers.keySet());
    taken.addAll(holders.keySet());
    taken.addAll(runs.keySet());
    waits.values().forEach(wait -> taken.addAll(wait.wanted()));
    taken.removeIf(
        resource ->
            resource.kind() != Resource.Kind.COMPONENT
                || holder(goal, resource).or(() -> firstInQueue(goal, resource)).isEmpty());
    return taken;
  }

  /**
   * The goals that wait for each other in a circle with this one, itself first; or none. Where it
   * is a step for which something is held, the goal that holds it stands in its place, last.
   */
  public List<String> circle(String goal) {
    Deque<String> path = new ArrayDeque<>();
    return leads(goal, goal, path, new HashSet<>()) ? List.copyOf(path) : List.of();
  }

  private boolean leads(String from, String to, Deque<String> path, Set<String> seen) {
    path.addLast(from);
    for (WaitsFor edge : waitsFrom(from)) {
      String next = edge.holder();
      if (!isSoStill(edge) || isOne(next, from)) {
        continue;
      }
      if (GoalId.isOfStep(to, next)) {
        path.removeFirst();
        path.addLast(next);
        return true;
      }
      if (next.equals(to) || seen.add(next) && leads(next, to, path, seen)) {
        return true;
      }
    }
    path.removeLast();
    return false;
  }

  /** Who holds something for steps is not done before they are. */
  private List<WaitsFor> waitsFrom(String goal) {
    return waits.entrySet().stream()
        .filter(e -> e.getKey().equals(goal) || GoalId.isOfStep(e.getKey(), goal))
        .flatMap(e -> e.getValue().edges().stream())
        .toList();
  }

  public boolean isBefore(String goal, String other) {
    return ownStanding(goal).compareTo(ownStanding(other)) < 0;
  }

  /** Who waits is told of a change only after it. */
  private boolean isSoStill(WaitsFor edge) {
    Wait next = waits.get(edge.holder());
    return edge.resource().kind() == Resource.Kind.FACT
        || edge.resource().kind() == Resource.Kind.END
        || holder(edge.goalId(), edge.resource()).filter(edge.holder()::equals).isPresent()
        || next != null && next.wanted().contains(edge.resource());
  }

  public GoalPriority ownStanding(String goal) {
    return standings.getOrDefault(goal, new GoalPriority(0, Optional.empty(), 0));
  }

  /** A goal goes as early as the first of those that wait for it. */
  public GoalPriority standing(String goal) {
    return standing(goal, new HashSet<>());
  }

  /** The same, as if this one did not wait. */
  public GoalPriority standingWithout(String goal, String waiter) {
    return standing(goal, new HashSet<>(Set.of(waiter)));
  }

  private GoalPriority standing(String goal, Set<String> passed) {
    GoalPriority raised = ownStanding(goal);
    passed.add(goal);
    for (Map.Entry<String, Wait> wait : waits.entrySet()) {
      if (!passed.contains(wait.getKey())
          && wait.getValue().edges().stream()
              .map(WaitsFor::holder)
              .anyMatch(holder -> holder.equals(goal) || GoalId.isOfStep(goal, holder))) {
        raised = raised.raisedTo(standing(wait.getKey(), passed));
      }
    }
    return raised;
  }
}
