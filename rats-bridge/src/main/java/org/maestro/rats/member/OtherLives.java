package org.maestro.rats.member;

import java.util.HashMap;
import java.util.Map;
import org.maestro.rats.protocol.MemberStatus;

/**
 * Tells from what is said in a member's name whether another one of that name is alive
 * (Three-layered architecture, 2; M9), or whether it is only told late that a former life has
 * ended. Clock thread only.
 *
 * <p>Where both have the same client id, the broker drops one for the other, and each finds the
 * other's will whenever it is back. A life that is over leaves one will: who leaves a second one,
 * after this life was dropped again, is alive.
 */
final class OtherLives {

  private final String own;
  private final Map<String, Integer> ended = new HashMap<>();
  private int drops;
  private boolean heardItself;
  private boolean heardItselfSince;

  /**
   * @param own the boot of this life
   */
  OtherLives(String own) {
    this.own = own;
  }

  /** Whether what this life says has ever come back to it. */
  boolean heardItself() {
    return heardItself;
  }

  /** This life has lost its connection. */
  void dropped() {
    drops++;
  }

  /** Returns whether this was said by another one that is alive. */
  boolean isAlive(MemberStatus status) {
    if (status.boot().equals(own)) {
      boolean ready = status.phase() == MemberStatus.Phase.READY;
      heardItself |= ready;
      heardItselfSince |= ready;
      return false;
    }
    return switch (status.phase()) {
      case DISCONNECTED -> false;
      case LOST -> isToldAgain(status.boot());
      default -> heardItself;
    };
  }

  /** The same will, read once more before this life's own word took its place, says nothing new. */
  private boolean isToldAgain(String other) {
    if (!heardItselfSince) {
      return false;
    }
    heardItselfSince = false;
    Integer before = ended.putIfAbsent(other, drops);
    return before != null && before < drops;
  }
}
