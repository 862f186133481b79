package org.maestro.coordination.api;

import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * The answer of one member to being asked for one of its features, when a plan was made.
 *
 * @param step of the plan, which is of that feature; empty: none is
 * @param chosen whether that step is the member's
 */
public record BidRecord(
    OptionalInt step, String member, String feature, boolean chosen, Answer answer) {

  /** The content of an answer. */
  public sealed interface Answer {}

  /**
   * A price for the step.
   *
   * @param cost in cost units; empty where it depends on what the step would be, or on what is not
   *     known
   * @param seconds that it would take, simulated
   */
  public record Priced(Kind kind, OptionalDouble cost, OptionalDouble seconds) implements Answer {}

  /** A refusal of all, or of just this. */
  public record Refused(String reason) implements Answer {}

  /** It was not asked, since it is not to be counted on. */
  public record NotAsked(String reason) implements Answer {}

  /** The certainty of a price. */
  public enum Kind {
    /** Named by the member for just this step. */
    EXACT,
    /** By the constant or the formula that the member has stated. */
    STATED,
    /** The least that it can be. */
    AT_LEAST
  }
}
