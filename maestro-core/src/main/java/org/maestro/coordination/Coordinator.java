package org.maestro.coordination;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.rats.time.Clock;

/**
 * Pursues the goals of one scope. Confined to one thread: the owner's, on which all ports answer
 * too.
 *
 * <p>Source: paper section 3.3, checklist M4, M17, M21, M55, M76.
 */
public final class Coordinator {
  private final Ports ports;
  private final JournaledCrew crew;
  private final Roster roster = new Roster();
  private final Rivals rivals = new Rivals();
  private final ExactPrices exactPrices = new ExactPrices();
  private final Map<String, GoalPursuit> pursuits = new LinkedHashMap<>();
  private int lastNumber;

  public Coordinator(Ports ports) {
    this.crew = new JournaledCrew(ports.crew(), ports.journal(), roster, ports.clock().instant());
    this.ports = ports.with(crew);
  }

  /**
   * Takes a goal on.
   *
   * @param ended told once, how it ended
   * @return the goal's id, G1, G2 ...
   * @throws InvalidGoalException when it speaks of what nobody knows
   */
  public String submit(GoalRequest request, Consumer<GoalOutcome> ended) {
    new GoalCheck(ports.knowledge().home()).check(request.goal());
    int number = ++lastNumber;
    String id = "G" + number;
    GoalPursuit pursuit =
        new GoalPursuit(
            id,
            request,
            ports,
            roster,
            rivals,
            exactPrices,
            outcome -> ports.journal().afterwards(() -> ended.accept(outcome)));
    pursuits.put(id, pursuit);
    rivals.enter(pursuit, new Standing(request.priority(), request.deadline(), number));
    ports.journal().write(new JournalEntry.Submitted(id, request));
    ports.thinking().think(() -> id, started -> rivals.run(pursuit::start));
    request.deadline().ifPresent(deadline -> endAt(deadline, pursuit));
    return id;
  }

  /** The clock's thread only hands over. */
  private void endAt(Duration deadline, GoalPursuit pursuit) {
    Clock clock = ports.clock();
    clock.schedule(
        deadline.minus(clock.now()),
        pursuit.id(),
        () -> ports.thinking().think(pursuit::id, passed -> rivals.run(pursuit::deadlinePassed)));
  }

  /** Returns whether there is such a goal, and it had not ended yet. */
  public boolean cancel(String goalId, String who) {
    GoalPursuit pursuit = pursuits.get(goalId);
    if (pursuit == null || pursuit.status().state().isFinal()) {
      return false;
    }
    rivals.run(() -> pursuit.cancel(who));
    return true;
  }

  public void memberPresent(String member) {
    memberPresent(member, Optional.empty());
  }

  /**
   * The member can be used.
   *
   * @param life names the life that it lives, and the way in which it is called: calls of another
   *     life are unknown to it
   */
  public void memberPresent(String member, Optional<String> life) {
    roster.present(member, life);
    ports.journal().write(new JournalEntry.MemberCame(member, life));
  }

  /**
   * The member is gone: what it knew of itself is forgotten, and plans that count on it are made
   * anew.
   */
  public void memberLost(String member, String reason) {
    if (!roster.isPresent(member)) {
      return;
    }
    roster.absent(member, reason);
    ports.journal().write(new JournalEntry.MemberWent(member, reason));
    exactPrices.forget(member);
    ports.knowledge().lost(member);
    rivals.run(
        () -> {
          rivals.leases().lost(member);
          rivals.all().forEach(pursuit -> pursuit.memberLost(member));
        });
  }

  public void knowledgeChanged(KnowledgeBase.Change change) {
    exactPrices.forget(change.source().agent());
    Interest changed = Interest.of(change.facts(), ports.knowledge().home().vocabulary());
    rivals.run(() -> rivals.all().forEach(pursuit -> pursuit.knowledgeChanged(change, changed)));
  }

  public boolean isPresent(String member) {
    return roster.isPresent(member);
  }

  public List<GoalStatus> goals() {
    List<GoalStatus> goals = new ArrayList<>();
    pursuits.values().forEach(pursuit -> goals.add(pursuit.status()));
    return goals;
  }

  /** The wait-for graph: which goal waits for what, and which goal has it. */
  public List<WaitsFor> waits() {
    return rivals.leases().graph();
  }
}
