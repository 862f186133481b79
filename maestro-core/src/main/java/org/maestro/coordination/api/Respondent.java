package org.maestro.coordination.api;

import java.util.Optional;

/**
 * Somebody who answers a question of a script.
 *
 * @param caller the agent that brings the answer, and its user where that is proven
 * @param person of the home whose answer it is, as the caller says; empty: it does not say
 */
public record Respondent(String caller, Optional<String> person) {

  /** One who does not say whose answer it brings. */
  public Respondent(String caller) {
    this(caller, Optional.empty());
  }

  /** By which stories tell of it. */
  public String name() {
    return person.orElse(caller);
  }
}
