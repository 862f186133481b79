package org.maestro.agents.lives;

/**
 * A listener to what becomes of the agents of a platform, each called by its local name. Called by
 * any thread, also by JADE's own, which must not be held up.
 */
public interface AgentLifeListener {

  /** An agent is there that was not, also one in the place of another. */
  default void agentBegins(String agent) {}

  /** The agent has come to this container, by moving itself. */
  default void agentArrives(String agent, String container) {}

  /** The agent gives no sign of life: nothing is to be asked of it until it is trusted or ended. */
  default void agentDoubted(String agent, String reason) {}

  /** The agent gives signs of life again. */
  default void agentTrusted(String agent) {}

  /** The agent hangs in a container that lives. */
  default void agentHangs(String agent) {}

  /**
   * The agent's life in its container is over, killed or with it; whether it ended for good or is
   * to begin elsewhere is told next, by whoever knows.
   */
  default void agentDied(String agent) {}

  /** The agent is to begin elsewhere, or again, and announces itself there. */
  default void agentMoves(String agent) {}

  /** The agent ended for good. */
  default void agentEnded(String agent) {}

  /**
   * The member has no agent, and gets none for now.
   *
   * @param reason a clause
   */
  default void agentStaysAway(String member, String reason) {}

  /** The container is no more. */
  default void containerGone(String container) {}
}
