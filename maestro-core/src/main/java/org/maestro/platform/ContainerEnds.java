package org.maestro.platform;

import jade.wrapper.AgentContainer;
import jade.wrapper.StaleProxyException;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.locks.LockSupport;

/** Ends JADE containers, at once or beside the caller. */
final class ContainerEnds {
  private static final Duration LEAST_AGE = Duration.ofMillis(3_100);

  private ContainerEnds() {}

  /** Ends a container; when it returns the platform knows its name no more. */
  static void endNow(AgentContainer container) {
    kill(container);
  }

  /** Ends a container beside the caller; the threads it leaves are daemons. */
  static void end(AgentContainer container) {
    endBeside(() -> kill(container));
  }

  /**
   * Ends the containers of a platform one after the other beside the caller, the main one last, as
   * the others need it to say goodbye. JADE makes containers younger than three seconds wait for
   * that age.
   *
   * @param sinceNanos when the platform started
   */
  static void end(List<AgentContainer> containers, long sinceNanos) {
    endBeside(
        () -> {
          LockSupport.parkNanos(sinceNanos + LEAST_AGE.toNanos() - System.nanoTime());
          containers.forEach(ContainerEnds::kill);
        });
  }

  /** The same for one that the platform has given up: it may wait for ever, and nobody for it. */
  static void abandon(AgentContainer container) {
    endBeside(
        () -> {
          try {
            container.kill();
          } catch (StaleProxyException e) {
            // It is gone already, which is what was wanted.
          }
        });
  }

  private static void endBeside(Runnable deed) {
    Thread ending = new Thread(deed, "maestro-container-end");
    ending.setDaemon(true);
    ending.start();
  }

  private static void kill(AgentContainer container) {
    synchronized (JadeRuntime.ONE_AT_A_TIME) {
      try {
        container.kill();
      } catch (StaleProxyException e) {
        // It is gone already, which is what was wanted.
      }
    }
  }
}
