package org.maestro.platform.threads;

import jade.core.Profile;
import jade.core.ResourceManager;
import org.maestro.agents.GenericAgent;

/**
 * Makes the threads of a container (JADE takes it by its class name). Generic agents, which there
 * may be thousands of and which only pass messages on, get virtual ones where those were chosen.
 * Who plans and computes, and agents of others, which may do anything, stay on threads that the
 * system shares the cores out among. JADE's own maker puts threads into groups that it never gives
 * back, and with them all that the container had. Thread-safe.
 */
public final class ContainerThreads implements ResourceManager {
  private volatile AgentThreads kind = AgentThreads.PLATFORM;

  @Override
  public void initialize(Profile profile) {
    kind = AgentThreads.of(profile);
  }

  @Override
  @SuppressWarnings("ThreadPriorityCheck") // Nothing rests on it.
  public Thread getThread(int purpose, String name, Runnable work) {
    if (kind == AgentThreads.VIRTUAL && purpose == USER_AGENTS && work instanceof GenericAgent) {
      return VirtualThreads.make(name, work);
    }
    Thread thread = new Thread(work, name);
    thread.setPriority(priority(purpose));
    return thread;
  }

  /** As JADE itself has them. */
  private static int priority(int purpose) {
    return switch (purpose) {
      case TIME_CRITICAL -> Thread.MAX_PRIORITY;
      case SYSTEM_AGENTS -> Thread.NORM_PRIORITY + 1;
      default -> Thread.NORM_PRIORITY;
    };
  }

  @Override
  public void releaseResources() {
    // Threads end with the agents that run on them.
  }
}
