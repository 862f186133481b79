package org.maestro.random;

import java.util.List;
import java.util.Map;
import org.maestro.sl.Term;

/** The platform's claim about a goal at its end. */
record Claim(
    String goal,
    boolean reached,
    boolean confirmed,
    Map<String, Term> binding,
    List<String> reasons) {

  /** News of a goal that is to be held: it is so, or cannot be, or merely is not for a while. */
  static Claim ofHeld(String goal, boolean isSo, boolean confirmed, List<String> reasons) {
    return new Claim(goal, isSo, confirmed, Map.of(), reasons);
  }

  /** Whether it says no more than that it is not so now. */
  boolean isLossOnly() {
    return !reached && reasons.isEmpty();
  }

  @Override
  public String toString() {
    return reached
        ? "reached" + (confirmed ? "" : ", not seen") + " " + binding
        : "not reached: " + String.join(" ", reasons);
  }
}
