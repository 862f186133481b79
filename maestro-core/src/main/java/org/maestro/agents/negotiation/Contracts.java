package org.maestro.agents.negotiation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;

/**
 * The promises of agents for the goals of one coordinator (contract net). A part of a plan is
 * awarded, then held or broken; orders wait until it is known which. Who broke two contracts of a
 * goal in a row is not asked again for it. Agent thread only.
 */
public final class Contracts {
  private static final int CHANCES = 2;

  private final Map<String, Map<String, Standing>> standingsByGoal = new TreeMap<>();

  /** The standing of a member with a goal: its latest contract, and those it broke. */
  private static final class Standing {
    private Optional<Contract> latest = Optional.empty();
    private int broken;
    private String howBroken = "";
  }

  /** A part awarded to a member; it is settled exactly once, later calls change nothing. */
  static final class Contract {
    private final Standing standing;
    private final List<Consumer<Optional<String>>> waiting = new ArrayList<>();
    private boolean settled;

    private Contract(Standing standing) {
      this.standing = standing;
    }

    void held() {
      settle(Optional.empty());
    }

    /**
     * @param how a sentence about the member, its name first
     */
    void broken(String how) {
      settle(Optional.of(how));
    }

    boolean isSettled() {
      return settled;
    }

    private void settle(Optional<String> how) {
      if (settled) {
        return;
      }
      settled = true;
      standing.broken = how.isPresent() ? standing.broken + 1 : 0;
      standing.howBroken = how.orElse("");
      List.copyOf(waiting).forEach(waiter -> waiter.accept(how));
      waiting.clear();
    }
  }

  Contract award(String goalId, String member) {
    Standing standing =
        standingsByGoal
            .computeIfAbsent(goalId, id -> new TreeMap<>())
            .computeIfAbsent(member, m -> new Standing());
    Contract contract = new Contract(standing);
    standing.latest = Optional.of(contract);
    return contract;
  }

  /**
   * Calls back once it is known whether the member holds its part: at once when it is, or when none
   * was awarded.
   *
   * @param settled is told how the contract was broken, or nothing when it holds
   */
  public void whenSettled(String goalId, String member, Consumer<Optional<String>> settled) {
    Optional<Contract> contract = standing(goalId, member).flatMap(s -> s.latest);
    if (contract.isEmpty()) {
      settled.accept(Optional.empty());
    } else if (contract.get().settled) {
      String how = contract.get().standing.howBroken;
      settled.accept(how.isEmpty() ? Optional.empty() : Optional.of(how));
    } else {
      contract.get().waiting.add(settled);
    }
  }

  /** Why the member is not asked any more for the goal. */
  Optional<String> distrust(String goalId, String member) {
    return standing(goalId, member)
        .filter(s -> s.broken >= CHANCES)
        .map(s -> "is not asked any more for this goal: " + s.howBroken);
  }

  /** The goal is over. */
  public void forget(String goalId) {
    standingsByGoal.remove(goalId);
  }

  public boolean isEmpty() {
    return standingsByGoal.isEmpty();
  }

  private Optional<Standing> standing(String goalId, String member) {
    return Optional.ofNullable(standingsByGoal.get(goalId)).map(m -> m.get(member));
  }
}
