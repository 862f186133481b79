package org.maestro.rats.protocol;

/** Whether a member is there; retained, and its last will. */
public record MemberStatus(String member, Phase phase, String boot) {

  public enum Phase {
    INIT,
    READY,
    DISCONNECTED,
    LOST
  }
}
