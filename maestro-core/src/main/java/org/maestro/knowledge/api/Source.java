package org.maestro.knowledge.api;

/**
 * The provenance of a fact.
 *
 * @param agent who said or did it: a member's id, or {@code user}; of what stands in the home the
 *     name of its file, {@code home} where it has none
 */
public record Source(Kind kind, String agent) {
  /** The source of what stands in a home that was not read from a file. */
  public static final String HOME = "home";

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
