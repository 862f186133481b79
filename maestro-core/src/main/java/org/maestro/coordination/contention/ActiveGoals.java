package org.maestro.coordination.contention;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.Executor;
import java.util.stream.Collectors;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.facts.FactsMaskedByRunningSteps;
import org.maestro.coordination.lessons.Experience;
import org.maestro.coordination.worth.Appraisals;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.rats.time.Clock;

/**
 * The goals under way beside each other, what they have of what all of them want, and whose turn it
 * is. A goal that may go on is looked at when the one at work has come to the end of what it does:
 * no goal's decision is made in the middle of another's.
 */
public final class ActiveGoals {
  private final Leases leases = new Leases(this::wake);
  private final Map<String, ActiveGoal> pursuits = new LinkedHashMap<>();
  private final Deque<Runnable> errands = new ArrayDeque<>();
  private final Set<String> woken = new LinkedHashSet<>();
  private final Experience experience = new Experience();
  private final Appraisals appraisals;
  private final OtherManagers otherManagers;
  private boolean atWork;
  private volatile boolean any;

  /**
   * @param appraisals of the same goals
   * @param agents of the members, which are told what is wanted that other managers have
   */
  public ActiveGoals(Clock clock, Executor owner, Appraisals appraisals, ActionDispatcher agents) {
    this.appraisals = appraisals;
    this.otherManagers = new OtherManagers(this, agents, clock, owner);
  }

  public Leases leases() {
    return leases;
  }

  public Appraisals appraisals() {
    return appraisals;
  }

  /** The goals of other managers that contend with these. */
  public OtherManagers otherManagers() {
    return otherManagers;
  }

  /** What the steps of all of them have shown of members. */
  public Experience experience() {
    return experience;
  }

  public void enter(ActiveGoal pursuit, GoalPriority standing) {
    pursuits.put(pursuit.id(), pursuit);
    any = true;
    leases.enter(pursuit.id(), appraisals.graded(pursuit.id(), standing));
  }

  /** Its worth is another, and so is that of all its parts. */
  public void rank(String goal, GoalPriority standing) {
    List.copyOf(pursuits.keySet()).stream()
        .filter(id -> GoalId.whole(id).equals(goal))
        .forEach(id -> leases.rank(id, standing));
  }

  /** Whether a goal is not over, and the one that stood back for it does not go before it now. */
  public boolean goesOnBefore(String other, String goal) {
    return contends(other) && !leases.ownStanding(goal).outranks(leases.ownStanding(other));
  }

  /** Whether the one that goes first may be the other before long: by what they are worth. */
  public boolean mayTurn(String goal, String other) {
    return leases.ownStanding(goal).priority() == leases.ownStanding(other).priority()
        && (appraisals.isWeighed(goal) || appraisals.isWeighed(other));
  }

  /**
   * Why the one goes before the other, as the end of a sentence, where it is by what they are
   * worth; else empty.
   */
  public String whyFirst(String first, String second) {
    boolean byWorth =
        leases.ownStanding(first).priority() == leases.ownStanding(second).priority()
            && leases.ownStanding(first).outranks(leases.ownStanding(second));
    return byWorth ? appraisals.comparison(first, second) : "";
  }

  /**
   * What a goal had before this coordinator was there is its own though it is not taken up yet.
   *
   * @param components of members
   */
  public void keep(String goal, GoalPriority standing, Set<Resource> components) {
    leases.enter(goal, appraisals.graded(goal, standing));
    leases.keep(goal, components);
  }

  /** It is over. */
  public void leave(String goal) {
    pursuits.remove(goal);
    any = !pursuits.isEmpty();
    leases.leave(goal);
  }

  /** Whether there is one; any thread may ask. */
  public boolean isAny() {
    return any;
  }

  public Optional<ActiveGoal> find(String goal) {
    return Optional.ofNullable(pursuits.get(goal));
  }

  /** Whether it is a goal that is not over, or one of another manager that waits for these. */
  public boolean contends(String goal) {
    return pursuits.containsKey(goal) || otherManagers.isWaiting(goal);
  }

  private Optional<Contender> contender(String goal) {
    Optional<Contender> own = Optional.ofNullable(pursuits.get(goal));
    return own.or(() -> otherManagers.find(goal));
  }

  /** Those that are not over, oldest first. */
  public List<ActiveGoal> all() {
    return new ArrayList<>(pursuits.values());
  }

  List<ActiveGoal> others(String goal) {
    return pursuits.values().stream().filter(p -> !isOfIt(p, goal)).toList();
  }

  /** Whether a goal is that one, or one for a step of which that one is pursued. */
  private static boolean isOfIt(ActiveGoal pursuit, String goal) {
    return pursuit.id().equals(goal) || GoalId.isOfStep(goal, pursuit.id());
  }

  /**
   * What is known, without what any step under way is just changing, but the one for which the goal
   * is pursued.
   */
  public FactsMaskedByRunningSteps factsBesideSteps(
      String goal, Snapshot now, Vocabulary vocabulary) {
    FactsMaskedByRunningSteps facts = new FactsMaskedByRunningSteps(now, vocabulary);
    pursuits.values().stream()
        .filter(pursuit -> !GoalId.isOfStep(goal, pursuit.id()))
        .forEach(pursuit -> pursuit.underway().addTo(facts));
    return facts;
  }

  /** Members of whom other goals have something, or come first in asking for it. */
  public Set<String> busyMembers(String goal) {
    return leases.takenFrom(goal).stream()
        .map(Resource::owner)
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /**
   * How long it may take until all of this is free: what its holders have yet to do, and those who
   * come before. Who goes first waits only until a step ends.
   */
  public double secondsUntilFree(String goal, List<WaitsFor> obstacles) {
    double longest = 0;
    for (WaitsFor obstacle : obstacles) {
      double seconds =
          contender(obstacle.holder()).map(holder -> secondsOf(goal, holder, obstacle)).orElse(0.0);
      for (String other : leases.before(goal, obstacle.resource())) {
        if (!other.equals(obstacle.holder())) {
          seconds += contender(other).map(Contender::remainingSeconds).orElse(0.0);
        }
      }
      longest = Math.max(longest, seconds);
    }
    return longest;
  }

  private double secondsOf(String goal, Contender holder, WaitsFor obstacle) {
    boolean givesWay =
        leases.standing(goal).outranks(leases.standing(holder.id()))
            && !holder.isTied(obstacle.resource().owner());
    return givesWay ? holder.secondsOfRunningSteps() : holder.remainingSeconds();
  }

  /** Who has what the goal waits for, and does not go first, is to give way. */
  public void askForWay(String goal, List<WaitsFor> obstacles) {
    for (WaitsFor obstacle : obstacles) {
      GoalPriority others = leases.standingWithout(obstacle.holder(), goal);
      if (leases.standing(goal).outranks(others)) {
        contender(obstacle.holder()).ifPresent(holder -> holder.giveWayTo(goal));
      }
    }
  }

  /** Steps under way may still end a circle; then it is looked at again. */
  public void breakCircle(String goal) {
    List<Contender> circle =
        leases.circle(goal).stream().flatMap(one -> contender(one).stream()).toList();
    if (circle.isEmpty() || circle.stream().anyMatch(one -> !one.underway().isEmpty())) {
      return;
    }
    boolean isAmongManagers = circle.stream().anyMatch(one -> find(one.id()).isEmpty());
    Comparator<Contender> order =
        isAmongManagers
            ? otherManagers.order()
            : Comparator.comparing(one -> leases.ownStanding(one.id()));
    String first = circle.stream().min(order).orElseThrow().id();
    circle.stream().max(order).orElseThrow().stepBackFor(first);
  }

  /** Does the work, and then all that it makes possible. */
  public void run(Runnable work) {
    errands.addLast(work);
    if (atWork) {
      return;
    }
    atWork = true;
    try {
      while (!errands.isEmpty()) {
        errands.removeFirst().run();
        if (errands.isEmpty()) {
          otherManagers.tellWhatIsWanted();
        }
      }
    } finally {
      atWork = false;
      errands.clear();
      woken.clear();
    }
  }

  private void wake(String goal) {
    if (woken.add(goal)) {
      run(
          () -> {
            woken.remove(goal);
            contender(goal).ifPresent(Contender::advance);
          });
    }
  }
}
