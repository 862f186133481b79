package org.maestro.agents.runtime;

import java.time.Duration;

/**
 * The timeouts of the agents of a platform that wait for each other: no wait is without an end.
 * Wall time on a paced clock, however fast, as messages do not travel faster on it; simulated time
 * on a stepped one. An agent that never answers costs a goal no more than this.
 *
 * @param bid from a call for proposals to the last answer that counts; the round closes earlier
 *     when all have answered
 * @param contract from {@code accept-proposal} until the agent has said that it holds its part
 * @param offer how long an agent stands by a proposal that is neither accepted nor rejected
 * @param agreement from an order until the agent has taken it up
 * @param report what the report of a step may take beyond the step's own time limit
 * @param quote from a question for exact prices to the answer
 */
public record ProtocolTimeouts(
    Duration bid,
    Duration contract,
    Duration offer,
    Duration agreement,
    Duration report,
    Duration quote) {

  /** Generous enough for a slow machine: a good agent must not be taken for a silent one. */
  public static ProtocolTimeouts standard() {
    return new ProtocolTimeouts(
        Duration.ofSeconds(10),
        Duration.ofSeconds(5),
        Duration.ofMinutes(5),
        Duration.ofSeconds(10),
        Duration.ofSeconds(10),
        Duration.ofSeconds(7));
  }
}
