package org.maestro.knowledge.api;

/**
 * The provenance of a fact.
 *
 * @param agent who said or did it: a member's id, {@code home} or {@code user}
 */
public record Source(Kind kind, String agent) {

  public enum Kind {
    /** Stands in the home file or a description. */
    DESCRIBED,
    /** A member says it of itself. */
    STATED,
    /** Seen or measured. */
    OBSERVED,
    /** The effect of a step done; not yet seen. */
    EXPECTED
  }
}
