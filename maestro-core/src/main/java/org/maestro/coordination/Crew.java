package org.maestro.coordination;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.knowledge.FeatureRun;
import org.maestro.planning.Step;
import org.maestro.sl.Term;

/**
 * The agents at work, as coordination sees them. Reports come on the coordinator's thread, exactly
 * one for each order.
 */
public interface Crew {

  Performance perform(Order order, Consumer<Report> reported);

  /** A step to be done now. */
  record Order(String goalId, Step step, Map<String, Argument> parameters, Duration timeout) {}

  /** A step under way, or a continuous feature that was established by it. */
  interface Performance {
    /** Ends it; a step still under way reports its end. */
    void cancel();
  }

  /**
   * How a step ended; for a continuous feature, that it is established.
   *
   * @param outputs empty unless it succeeded
   * @param problem one sentence unless it succeeded
   * @param refs facts that a failure teaches
   */
  record Report(
      boolean succeeded,
      Map<String, Term> outputs,
      Optional<String> problem,
      List<FeatureRun.Learnt> refs) {}
}
