package org.maestro.coordination.api;

import java.util.List;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * The state before a goal.
 *
 * @param parts what is to be so again
 * @param unknown what was changed, and nobody knew before
 */
public record Former(List<Formula> parts, List<String> unknown) {
  /** Of a goal that has changed nothing. */
  public static final Former NOTHING = new Former(List.of(), List.of());

  public Former {
    parts = List.copyOf(parts);
    unknown = List.copyOf(unknown);
  }

  /** All of it as one goal; empty when nothing is known to have been changed. */
  public Optional<Formula> wish() {
    return parts.size() < 2 ? parts.stream().findFirst() : Optional.of(new Formula.And(parts));
  }
}
