package org.maestro.platform.threads;

import jade.core.Profile;
import jade.core.ResourceManager;
import org.maestro.agents.GenericAgent;

/**
 * Makes the threads of a container (JADE takes it by its class name). Generic agents, which there
 * may be thousands of and which only pass messages on, get virtual ones. Who plans and computes,
 * and agents of others, which may do anything, stay on threads that the system shares the cores out
 * among. Thread-safe.
 */
public final class ThreadsForMany implements ResourceManager {

  @Override
  public Thread getThread(int kind, String name, Runnable work) {
    if (kind == USER_AGENTS && work instanceof GenericAgent) {
      return VirtualThreads.make(name, work);
    }
    Thread thread = new Thread(work, name);
    thread.setPriority(priority(kind));
    return thread;
  }

  /** As JADE itself has them. */
  private static int priority(int kind) {
    return switch (kind) {
      case TIME_CRITICAL -> Thread.MAX_PRIORITY;
      case SYSTEM_AGENTS -> Thread.NORM_PRIORITY + 1;
      default -> Thread.NORM_PRIORITY;
    };
  }

  @Override
  public void initialize(Profile profile) {
    // There is nothing to be set.
  }

  @Override
  public void releaseResources() {
    // Threads end with the agents that run on them.
  }
}
