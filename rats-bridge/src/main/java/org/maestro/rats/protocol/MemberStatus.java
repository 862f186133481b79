package org.maestro.rats.protocol;

/** The presence of a member; retained, and its last will. */
public record MemberStatus(String member, Phase phase, String boot) {

  public enum Phase {
    INIT,
    READY,
    DISCONNECTED,
    LOST
  }
}
