package org.maestro.console.states;

import java.util.Optional;

/**
 * The standing of a part, and why it is not well.
 *
 * @param why a sentence; empty when it is well
 */
record Derived(Standing standing, Optional<String> why) {
  static final Derived WELL = new Derived(Standing.WELL, Optional.empty());

  static Derived of(Standing standing, String why) {
    return new Derived(standing, Optional.of(why));
  }

  boolean isWell() {
    return standing == Standing.WELL;
  }
}
