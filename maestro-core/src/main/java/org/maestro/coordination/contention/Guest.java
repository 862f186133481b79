package org.maestro.coordination.contention;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;

/**
 * A goal of another manager, among the goals of this one: it stands in the queue for what it wants
 * as they do, and what it has none of them gets. What it does, and where it stands in queues
 * elsewhere, is not known. The coordinator's thread only.
 */
final class Guest implements Contender {
  /**
   * An assumption, as nobody tells: so long a goal of another manager may need what it has. A plan
   * without it that costs less than these seconds more is taken.
   */
  private static final double SECONDS_ASSUMED = 30;

  private final String id;
  private final ActiveGoals activeGoals;
  private final OtherManagers others;
  private final Map<String, ComponentWant> wantsByMember = new TreeMap<>();

  Guest(String id, ActiveGoals activeGoals, OtherManagers others) {
    this.id = id;
    this.activeGoals = activeGoals;
    this.others = others;
  }

  @Override
  public String id() {
    return id;
  }

  private Leases leases() {
    return activeGoals.leases();
  }

  /** It has these now; it needs not wait for them. */
  void has(String member, Set<Resource> resources) {
    wantsByMember.remove(member);
    leases().taken(id, resources);
    advance();
  }

  void wants(ComponentWant want) {
    wantsByMember.put(want.member(), want);
  }

  void wantsNoMore(String member) {
    if (wantsByMember.remove(member) != null) {
      advance();
    }
  }

  /** Its manager has given these back, or nobody knows any more that it has them. */
  void hasNoMore(Set<Resource> resources) {
    leases().letGo(id, resources);
  }

  boolean wantsOneOf(Set<Resource> resources) {
    return wantsByMember.values().stream()
        .anyMatch(want -> want.resources().stream().anyMatch(resources::contains));
  }

  boolean isWaiting() {
    return !wantsByMember.isEmpty();
  }

  /** What nobody here keeps or uses is its own, and its member's agent may give it. */
  @Override
  public void advance() {
    List<WaitsFor> obstacles = new ArrayList<>();
    Set<Resource> wanted = new TreeSet<>();
    for (ComponentWant want : List.copyOf(wantsByMember.values())) {
      List<WaitsFor> these = leases().obstaclesToKeep(id, want.resources());
      if (these.isEmpty()) {
        wantsByMember.remove(want.member());
        leases().keep(id, want.resources());
        others.giveBack(id, want);
      } else {
        wanted.addAll(want.resources());
        obstacles.addAll(these);
      }
    }
    if (obstacles.isEmpty()) {
      leases().stopWaiting(id);
    } else {
      leases().waitFor(id, wanted, obstacles);
      activeGoals.askForWay(id, obstacles);
      activeGoals.breakCircle(id);
    }
  }

  @Override
  public StepsUnderway underway() {
    return new StepsUnderway();
  }

  @Override
  public boolean isTied(String member) {
    return false;
  }

  @Override
  public double remainingSeconds() {
    return SECONDS_ASSUMED;
  }

  @Override
  public double secondsOfRunningSteps() {
    return SECONDS_ASSUMED;
  }

  /** Its own manager has it give way. */
  @Override
  public void giveWayTo(String other) {
    // The member's agent is told what the other wants, and tells that manager.
  }

  @Override
  public void stepBackFor(String other) {
    // Its own manager sees the same circle, and has it step back.
  }
}
