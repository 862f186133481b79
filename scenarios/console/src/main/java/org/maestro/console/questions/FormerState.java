package org.maestro.console.questions;

import java.util.Optional;
import org.maestro.agents.content.Words;

/**
 * The state before a goal.
 *
 * @param wish a formula that is to be so again; empty where nothing is known to have been changed
 * @param isKnown whether all that was changed is known to have been another
 */
public record FormerState(Optional<String> wish, boolean isKnown) {
  static FormerState of(Words told) {
    return new FormerState(told.string("before"), told.strings("unknown").isEmpty());
  }
}
