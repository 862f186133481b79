package org.maestro.random;

/**
 * The judgement on one claim.
 *
 * @param reason of a disagreement, in one sentence
 */
public record Verdict(String goal, Kind kind, String claim, String reason) {

  /** The classes that are counted. */
  public enum Kind {
    /** Said to be reached, and so it is. */
    ACHIEVED,
    /** Said to be reached, and as near to it as sensors can tell. */
    ACHIEVED_CLOSELY,
    /** Said to be impossible, and nobody could do it. */
    IMPOSSIBLE,
    /** Said to be impossible within moments of a change that nobody could know of yet. */
    TOO_LATE_TO_KNOW,
    /** Not taken on, with the reason. */
    REFUSED,
    /** Said to be reached as far as its doer says, which lies, and nobody else could look. */
    UNSEEN,
    /** Said to be reached, by a sensor that is broken and nobody else could look. */
    MISLED,
    /** Neither said to be impossible nor reached: too large for the planner. */
    GAVE_UP,
    /** Said to be reached, and it is not. */
    FALSELY_ACHIEVED,
    /** Said to be impossible, and it can be done. */
    FALSELY_IMPOSSIBLE,
    /** It never ended. */
    WITHOUT_END;

    /** Whether nothing was claimed that is not so. */
    public boolean agrees() {
      return compareTo(GAVE_UP) <= 0;
    }
  }

  static Verdict refused(String goal, String reason) {
    return new Verdict(goal, Kind.REFUSED, "not taken on", reason);
  }

  static Verdict withoutEnd(String goal) {
    return new Verdict(goal, Kind.WITHOUT_END, "", "it never ended");
  }
}
