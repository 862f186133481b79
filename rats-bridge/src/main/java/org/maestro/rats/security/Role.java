package org.maestro.rats.security;

import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;

/** The role of a person at a secured site's console; each may what those before it may. */
public enum Role {
  /** Looks and asks, and changes nothing. */
  VIEWER,

  /** States goals and gives them up, calls devices by hand, and has them go into a safe state. */
  OPERATOR,

  /** Adds, moves, reconfigures and removes agents, too. */
  ADMINISTRATOR;

  public boolean includes(Role other) {
    return compareTo(other) >= 0;
  }

  /** As files and documents name it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  static Optional<Role> of(String word) {
    return Stream.of(values()).filter(role -> role.word().equals(word)).findFirst();
  }
}
