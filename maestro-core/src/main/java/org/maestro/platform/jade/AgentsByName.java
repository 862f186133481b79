package org.maestro.platform.jade;

import jade.core.AID;
import jade.core.AgentManager;
import jade.core.ContainerID;
import jade.core.NameClashException;
import jade.core.NotFoundException;
import jade.core.UnreachableException;
import jade.security.JADESecurityException;
import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.content.StartWords;
import org.maestro.agents.content.Words;
import org.maestro.agents.device.Host;
import org.maestro.deployment.AgentStart;
import org.maestro.deployment.DeploymentException;

/**
 * Agents of the platform as JADE begins and ends them by their names, wherever they are. Any thread
 * may call.
 */
public final class AgentsByName {
  private static final Duration ENDS_WITHIN = Duration.ofSeconds(5);
  private static final Duration BETWEEN_LOOKS = Duration.ofMillis(5);

  private final String platform;
  private final Host main;
  private final Predicate<String> lives;

  /** Agents that were ended here, until JADE says so: it may say it late. */
  private final Set<String> ending = new ConcurrentSkipListSet<>();

  /**
   * @param platform its name
   * @param main of the platform's main container
   * @param lives whether JADE has an agent of that name
   */
  public AgentsByName(String platform, Host main, Predicate<String> lives) {
    this.platform = platform;
    this.main = main;
    this.lives = lives;
  }

  /** Its configuration goes to the other process; the class is there already. */
  public void create(AgentStart start) {
    try {
      manager()
          .create(
              start.agent(),
              GenericAgent.class.getName(),
              new Object[] {Words.print(StartWords.content(start))},
              new ContainerID(start.container(), null),
              null,
              null,
              null,
              null);
    } catch (UnreachableException
        | NotFoundException
        | NameClashException
        | JADESecurityException e) {
      throw new DeploymentException(
          "The agent %s could not begin in the container %s: %s"
              .formatted(start.agent(), start.container(), e.getMessage()));
    }
  }

  private AgentManager manager() {
    return main.manager()
        .orElseThrow(() -> new DeploymentException("The platform has no main container any more."));
  }

  /** JADE ends it beside the caller. */
  public void kill(String agent) {
    try {
      manager().kill(new AID(agent + "@" + platform, AID.ISGUID), null, null);
    } catch (NotFoundException e) {
      ending.remove(agent);
    } catch (UnreachableException | JADESecurityException e) {
      throw new DeploymentException(
          "The agent %s could not be ended: %s".formatted(agent, e.getMessage()));
    }
  }

  /** The agent ends here, to begin again. */
  public void endsHere(String agent) {
    ending.add(agent);
  }

  /** Whether the agent that ended, as JADE tells once for each, was to begin again elsewhere. */
  public boolean wasHandedOver(String agent) {
    return ending.remove(agent);
  }

  /**
   * JADE lets go of the name of a container that has ended in a thread of its own, and gives
   * whoever comes earlier another one.
   *
   * @return whether it has
   */
  public boolean awaitEnd(String container) {
    return await(() -> !main.keeps(container));
  }

  /** JADE ends agents beside who asks for it, and gives their names away only then. */
  public void awaitEnds(List<AgentStart> starts) {
    await(() -> starts.stream().noneMatch(start -> lives.test(start.agent())));
  }

  private static boolean await(BooleanSupplier condition) {
    long end = System.nanoTime() + ENDS_WITHIN.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        return false;
      }
      LockSupport.parkNanos(BETWEEN_LOOKS.toNanos());
    }
    return true;
  }
}
