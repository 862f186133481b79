package org.maestro.platform.jade;

import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import jade.wrapper.StaleProxyException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.maestro.agents.device.Host;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** Ends JADE containers, at once or beside the caller. */
public final class ContainerEnds {
  private static final Logger LOG = LoggerFactory.getLogger(ContainerEnds.class);
  private static final Duration LEAST_AGE = Duration.ofMillis(3_100);

  /** A young one has that age by then. */
  private static final Duration ABANDONED = Duration.ofMillis(3_500);

  /** The main container lets go of a name in a thread of its own. */
  private static final Duration LETTING_GO = Duration.ofSeconds(2);

  private static final Duration BETWEEN_LOOKS = Duration.ofMillis(10);

  private static final int MOST_TRIES = 3;
  private static final Duration BETWEEN_TRIES = Duration.ofMillis(100);

  private ContainerEnds() {}

  /**
   * Ends a container, if JADE can. The main container lets go of its name a moment later, in a
   * thread of its own.
   */
  public static void endNow(AgentContainer container) {
    kill(container);
  }

  /** Ends a container beside the caller; the threads it leaves are daemons. */
  public static void end(AgentContainer container) {
    endBeside(() -> kill(container));
  }

  /**
   * Ends the containers of a platform one after the other beside the caller, the main one last, as
   * the others need it to say goodbye, and as it complains of those that have just left. JADE makes
   * containers younger than three seconds wait for that age.
   *
   * @param host of the main container
   * @param sinceNanos when the platform started
   */
  public static void end(
      List<AgentContainer> others, AgentContainer main, Host host, long sinceNanos) {
    endBeside(
        () -> {
          LockSupport.parkNanos(sinceNanos + LEAST_AGE.toNanos() - System.nanoTime());
          List<String> names = others.stream().flatMap(other -> name(other).stream()).toList();
          others.forEach(ContainerEnds::killUnlessProcessEnds);
          awaitTheirNames(names, host);
          killUnlessProcessEnds(main);
        });
  }

  private static void killUnlessProcessEnds(AgentContainer container) {
    if (!isProcessEnding()) {
      kill(container);
    }
  }

  /** Then JADE ends its platforms by itself, and complains when somebody does so beside it. */
  private static boolean isProcessEnding() {
    Thread probe = new Thread(() -> {}, "probe");
    try {
      Runtime.getRuntime().addShutdownHook(probe);
      Runtime.getRuntime().removeShutdownHook(probe);
      return false;
    } catch (IllegalStateException ending) {
      return true;
    }
  }

  private static Optional<String> name(AgentContainer container) {
    try {
      return Optional.of(container.getContainerName());
    } catch (ControllerException e) {
      return Optional.empty();
    }
  }

  private static void awaitTheirNames(List<String> names, Host host) {
    long end = System.nanoTime() + LETTING_GO.toNanos();
    while (!isProcessEnding() && names.stream().anyMatch(host::keeps) && System.nanoTime() < end) {
      LockSupport.parkNanos(BETWEEN_LOOKS.toNanos());
    }
  }

  /**
   * Ends those that the platform has given up, which may wait for ever. Waits a while: what JADE
   * has for the whole process is new only to those that begin when all others have ended.
   */
  public static void abandon(List<AgentContainer> containers) {
    List<Thread> endings =
        containers.stream().map(container -> endBeside(() -> killUnguarded(container))).toList();
    long until = System.nanoTime() + ABANDONED.toNanos();
    try {
      for (Thread ending : endings) {
        ending.join(Math.max(1, Duration.ofNanos(until - System.nanoTime()).toMillis()));
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private static Thread endBeside(Runnable deed) {
    Thread ending = new Thread(deed, "maestro-container-end");
    ending.setDaemon(true);
    ending.start();
    return ending;
  }

  private static void kill(AgentContainer container) {
    JadeRuntime.PROCESS.end(() -> killUnguarded(container));
  }

  /**
   * JADE stumbles over an agent that was never started, or that ends by itself at the same moment,
   * leaves off half-way, and has the container live on under its name. The next time it gets
   * further.
   */
  private static void killUnguarded(AgentContainer container) {
    for (int attempt = 1; container.isJoined(); attempt++) {
      try {
        container.kill();
      } catch (StaleProxyException e) {
        LOG.info("JADE has left off ending a container", e);
        if (attempt == MOST_TRIES) {
          LOG.warn("A container does not end, however often JADE is asked for it");
          return;
        }
        LockSupport.parkNanos(BETWEEN_TRIES.toNanos());
      }
    }
  }
}
