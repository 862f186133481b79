package org.maestro.agents.supervision;

/**
 * An agent that was added to a running platform.
 *
 * @param container in which it lives
 * @param charge what it stands for, to be read after that; empty: a member of its own name
 */
public record Newcomer(String agent, String container, String charge) {
  /** Such as "The agent lamp-9 lives in lights." */
  public String sentence() {
    return "The agent %s lives in %s%s.".formatted(agent, container, charge);
  }
}
