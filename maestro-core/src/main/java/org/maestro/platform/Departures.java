package org.maestro.platform;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.pulse.Pulse;
import org.maestro.deployment.AgentStart;
import org.maestro.platform.failover.AgentFailover;
import org.maestro.platform.failover.HostSupervisor;
import org.maestro.platform.failover.TakeoverLinks;
import org.maestro.platform.jade.PlatformEvents;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The losses of a platform: agents that have ended or hang, and containers that are gone, begin
 * elsewhere, or are not counted on any more. Any thread may call.
 */
final class Departures implements PlatformEvents.Listener {
  private static final Logger LOG = LoggerFactory.getLogger(Departures.class);

  private final Deployer deployer;
  private final AgentFailover rescue;
  private final HostSupervisor starter;
  private final DeskAgent desk;
  private final Principals principals;
  private final BooleanSupplier closing;

  /**
   * @param principals who count on agents
   * @param closing whether the platform itself ends, and nothing is to begin any more
   */
  Departures(
      Deployer deployer,
      AgentFailover rescue,
      HostSupervisor starter,
      DeskAgent desk,
      Principals principals,
      BooleanSupplier closing) {
    this.deployer = deployer;
    this.rescue = rescue;
    this.starter = starter;
    this.desk = desk;
    this.principals = principals;
    this.closing = closing;
  }

  @Override
  public void born(String agent) {
    deployer.handing().begun(agent);
    principals.agentBegins(agent);
  }

  @Override
  public void moved(String agent, String container) {
    deployer.moved(agent, container);
  }

  @Override
  public void containerGone(String container) {
    if (!closing.getAsBoolean() && deployer.isElsewhere(container)) {
      deployer.deployment().containerGone(container);
      starter.gone(container);
    }
  }

  /**
   * A process that had taken a topic ended or was killed: its agents begin here again. One that
   * ended here is not counted on any more.
   */
  @Override
  public void died(String agent) {
    if (closing.getAsBoolean()) {
      return;
    }
    desk.agentEnded(agent);
    if (deployer.handing().isAsker(agent)) {
      beside(() -> deployer.givenUp(agent).forEach(this::givenBack));
    }
    if (agent.equals(AgentNames.COORDINATOR)) {
      principals.centralEnded();
      return;
    }
    if (deployer.wasHandedOver(agent)) {
      return;
    }
    if (agent.startsWith(AgentNames.ofHost(""))) {
      rescue.gone(agent.substring(AgentNames.ofHost("").length()));
      return;
    }
    Optional<AgentStart> lost = deployer.ended(agent);
    if (lost.isPresent()) {
      principals.agentMoves(agent);
      rescue.lost(agent, TakeoverLinks.controller(lost.get().container()));
    } else {
      principals.agentEnded(agent);
    }
  }

  private void givenBack(String agent, String controller) {
    LOG.warn("The process that was to have the agent of {} is no more", agent);
    rescue.lost(agent, controller);
  }

  private static void beside(Runnable work) {
    Thread starter = new Thread(work, "agent-starter");
    starter.setDaemon(true);
    starter.start();
  }

  /** An agent hangs in a container that lives: another takes its place. */
  void replaceHung(Pulse pulse, String agent) {
    if (closing.getAsBoolean() || deployer.deployment().find(agent).isEmpty()) {
      return;
    }
    LOG.warn("The agent of {} hangs; another takes its place", agent);
    beside(
        () -> {
          principals.agentMoves(agent);
          try {
            deployer.replace(agent, container -> pulse.end(container, agent));
          } catch (RuntimeException e) {
            LOG.warn("The agent of {} gets no other: {}", agent, e.getMessage());
          }
        });
  }
}
