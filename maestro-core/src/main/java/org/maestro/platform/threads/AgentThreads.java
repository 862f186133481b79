package org.maestro.platform.threads;

import jade.core.Profile;
import jade.util.leap.Properties;
import java.util.Locale;

/** The kinds of threads that generic agents can run on. */
public enum AgentThreads {
  /** One of the system's for each agent; at most some ten thousand fit into a machine. */
  PLATFORM,

  /** Many share the system's few: Java 24 and newer. */
  VIRTUAL;

  /** Names one of the kinds, in small letters, where it is not to be the best that Java has. */
  public static final String PROPERTY = "maestro.threads";

  /** JADE's profile key for who makes the threads of a container, a class name. */
  private static final String RESOURCE = "resource";

  /** Ours, for which of them are chosen. */
  private static final String CHOSEN = "maestro-threads";

  /**
   * As the property says, else as light as this Java has them.
   *
   * @throws IllegalArgumentException with one sentence, when the property names no kind or one that
   *     this Java does not have
   */
  public static AgentThreads chosen() {
    String named = System.getProperty(PROPERTY, "");
    if (named.isEmpty()) {
      return VirtualThreads.areThere() ? VIRTUAL : PLATFORM;
    }
    AgentThreads wanted = named(named);
    if (wanted == VIRTUAL && !VirtualThreads.areThere()) {
      throw new IllegalArgumentException(
          "Java %d has no virtual threads that agents can wait on; take 24 or newer, or leave out -D%s."
              .formatted(Runtime.version().feature(), PROPERTY));
    }
    return wanted;
  }

  private static AgentThreads named(String name) {
    for (AgentThreads kind : values()) {
      if (kind.name().toLowerCase(Locale.ROOT).equals(name)) {
        return kind;
      }
    }
    throw new IllegalArgumentException(
        "There are no threads called %s; -D%s is platform or virtual.".formatted(name, PROPERTY));
  }

  /** Has a container take them. */
  public void choose(Properties profile) {
    profile.setProperty(RESOURCE, ContainerThreads.class.getName());
    profile.setProperty(CHOSEN, name());
  }

  /** Those that a container was to take. */
  static AgentThreads of(Profile profile) {
    return valueOf(profile.getParameter(CHOSEN, PLATFORM.name()));
  }
}
