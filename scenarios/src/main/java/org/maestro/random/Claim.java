package org.maestro.random;

import java.util.List;
import java.util.Map;
import org.maestro.sl.Term;

/** What was said of a goal at its end. */
record Claim(
    String goal,
    boolean reached,
    boolean confirmed,
    Map<String, Term> binding,
    List<String> reasons) {

  @Override
  public String toString() {
    return reached
        ? "reached" + (confirmed ? "" : ", not seen") + " " + binding
        : "not reached: " + String.join(" ", reasons);
  }
}
