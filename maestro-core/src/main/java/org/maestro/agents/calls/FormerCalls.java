package org.maestro.agents.calls;

import java.io.Serializable;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.TreeSet;

/**
 * The record of calls that an agent takes along when it moves: the ways in which its members were
 * called, and the calls it has begun, so that what was ordered while it moved is done, and nothing
 * twice. Agent thread only.
 */
public final class FormerCalls implements Serializable {
  private static final long serialVersionUID = 1L;
  private static final int REMEMBERED = 512;

  private final TreeSet<String> lives = new TreeSet<>();
  private final LinkedHashSet<String> begun = new LinkedHashSet<>();

  void begun(String call) {
    begun.add(call);
    if (begun.size() > REMEMBERED) {
      begun.remove(begun.iterator().next());
    }
  }

  /** The agent moves: members are called in another way from now on. */
  public void moves(Set<String> livesUntilNow) {
    lives.addAll(livesUntilNow);
  }

  /**
   * Whether a call was ordered before the agent had moved, and has not been begun.
   *
   * @param boot of the member, which still lives the same life
   */
  boolean mayBegin(String life, String boot, String call) {
    return lives.contains(life) && life.startsWith(boot + "@") && !begun.contains(call);
  }
}
