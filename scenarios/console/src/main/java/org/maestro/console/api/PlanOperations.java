package org.maestro.console.api;

import static org.maestro.console.api.Operation.get;

import java.time.Duration;
import java.util.List;
import java.util.function.Supplier;
import org.maestro.console.access.Readership;
import org.maestro.console.api.Operation.Parameter;
import org.maestro.console.questions.AclQuestions;

/** The operations that tell how a goal is pursued, as data. */
public final class PlanOperations {
  private PlanOperations() {}

  /**
   * @param readership who may read what of goals that use private words
   * @param now the platform's time
   */
  public static List<Operation> of(
      AclQuestions questions, Readership readership, Supplier<Duration> now) {
    return List.of(
        get(
                "/goals/{goal}/plans",
                "plans",
                "A goal's latest plans, oldest first: why each was made, its steps, what a step"
                    + " needs of others, and what has become of it.",
                "plans",
                request ->
                    questions
                        .of(readership.name(request.visit()))
                        .plans(request.parameter("goal"))
                        .thenApply(plans -> plans.put("now_s", now.get().toMillis() / 1000.0)))
            .with(Api.GOAL),
        get(
                "/goals/{goal}/bids",
                "bids",
                "Who was asked when a plan was made, for which step, what each answered, and who"
                    + " was chosen.",
                "bids",
                request ->
                    questions
                        .of(readership.name(request.visit()))
                        .bids(request.parameter("goal"), request.number("plan")))
            .with(Api.GOAL, Parameter.number("plan", "Of which plan; without: of the latest.")));
  }
}
