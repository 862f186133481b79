package org.maestro.coordination.lessons;

import java.util.HashMap;
import java.util.Map;
import org.maestro.coordination.facts.FactsUnder;
import org.maestro.planning.api.StepKey;

/**
 * Steps of one goal that were said to be done, each with the facts under its precondition then. A
 * step that is wanted again with the facts unchanged was done in vain.
 */
public final class VainDeeds {
  private final Map<StepKey, String> done = new HashMap<>();

  /** The step is said to be done; returns whether it was before, and nothing has come of it. */
  public boolean isVain(StepKey step, String facts) {
    String before = done.put(step, facts);
    return before != null && FactsUnder.areSame(before, facts);
  }
}
