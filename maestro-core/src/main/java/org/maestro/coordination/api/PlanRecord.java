package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * A round of planning for a goal: why it came about, what was answered, and the plan, if any was
 * adopted.
 *
 * @param number in the goal's story
 * @param asked when it began, simulated time since the platform's start
 * @param cause why an earlier plan did not do, a sentence's end; empty for the first one
 * @param notAsked how many others would be dearer by what they describe, and were not asked
 * @param made the plan that came of it; empty: none was adopted, or not yet
 */
public record PlanRecord(
    int number,
    Duration asked,
    Optional<String> cause,
    List<BidRecord> bids,
    int notAsked,
    Optional<Made> made) {

  public PlanRecord {
    bids = List.copyOf(bids);
  }

  /**
   * The plan.
   *
   * @param at when it was adopted
   * @param toSee whether it is to see that the goal is reached, rather than to reach it
   * @param cost in cost units
   * @param lasts as it was planned
   */
  public record Made(
      Duration at, boolean toSee, double cost, Duration lasts, List<StepRecord> steps) {
    public Made {
      steps = List.copyOf(steps);
    }
  }

  /** A round that has begun. */
  public PlanRecord(int number, Duration asked, Optional<String> cause) {
    this(number, asked, cause, List.of(), 0, Optional.empty());
  }

  public PlanRecord answered(List<BidRecord> answers, int others) {
    return new PlanRecord(number, asked, cause, answers, others, made);
  }

  public PlanRecord made(Made plan) {
    return new PlanRecord(number, asked, cause, bids, notAsked, Optional.of(plan));
  }

  public List<StepRecord> steps() {
    return made.map(Made::steps).orElse(List.of());
  }

  /** The same, each step as it is now. */
  public PlanRecord with(UnaryOperator<StepRecord> now) {
    return made.map(
            plan ->
                made(
                    new Made(
                        plan.at(),
                        plan.toSee(),
                        plan.cost(),
                        plan.lasts(),
                        plan.steps().stream().map(now).toList())))
        .orElse(this);
  }
}
