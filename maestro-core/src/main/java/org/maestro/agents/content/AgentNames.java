package org.maestro.agents.content;

import java.util.Set;

/**
 * Local names of the agents of which a platform has one, and of those that are named after theirs.
 */
public final class AgentNames {
  /** The central coordinator agent, which people and other platforms ask. */
  public static final String COORDINATOR = "CCA";

  public static final String KNOWLEDGE = "knowledge";
  public static final String SUPERVISOR = "supervisor";

  /** Where people state goals and ask; it alone speaks for others than its own process. */
  public static final String DESK = "desk";

  /** Understands what people say, where that is an agent of its own. */
  public static final String LANGUAGE = "language";

  /** Pursues what is asked of it, where that is an agent beside the central one. */
  public static final String GOALS = "goals";

  private static final Set<String> CENTRAL = Set.of(COORDINATOR, KNOWLEDGE, SUPERVISOR, DESK);
  private static final String HOST = "host-";

  private AgentNames() {}

  /** Whether an agent of that name lives in the main container, and nowhere else. */
  public static boolean isCentral(String localName) {
    return CENTRAL.contains(localName);
  }

  /** The agent that offers a host to the platform. */
  public static String ofHost(String host) {
    return HOST + host;
  }
}
