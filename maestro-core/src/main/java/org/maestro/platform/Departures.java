package org.maestro.platform;

import java.util.Optional;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.lives.AgentLifeListener;
import org.maestro.agents.lives.AgentLives;
import org.maestro.deployment.AgentStart;
import org.maestro.platform.failover.AgentFailover;
import org.maestro.platform.failover.HostSupervisor;
import org.maestro.platform.failover.SignsOfLife;
import org.maestro.platform.failover.TakeoverLinks;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The places of agents whose lives change: what is lost or hangs begins elsewhere, what ended is
 * not counted on any more, and where one has come to is noted down. Any thread may call.
 */
final class Departures implements AgentLifeListener {
  private static final Logger LOG = LoggerFactory.getLogger(Departures.class);

  private final Deployer deployer;
  private final AgentFailover rescue;
  private final HostSupervisor starter;
  private final SignsOfLife signs;
  private final AgentLives lives;

  /**
   * @param lives is told what an agent's death means
   */
  Departures(
      Deployer deployer,
      AgentFailover rescue,
      HostSupervisor starter,
      SignsOfLife signs,
      AgentLives lives) {
    this.deployer = deployer;
    this.rescue = rescue;
    this.starter = starter;
    this.signs = signs;
    this.lives = lives;
  }

  @Override
  public void agentBegins(String agent) {
    deployer.handing().begun(agent);
  }

  @Override
  public void agentArrives(String agent, String container) {
    deployer.moved(agent, container);
  }

  @Override
  public void containerGone(String container) {
    if (deployer.isElsewhere(container)) {
      deployer.deployment().containerGone(container);
      starter.gone(container);
    }
  }

  /**
   * A process that had taken a topic ended or was killed: its agents begin here again. One that
   * ended here is not counted on any more.
   */
  @Override
  public void agentDied(String agent) {
    if (deployer.handing().isAsker(agent)) {
      beside(() -> deployer.givenUp(agent).forEach(this::givenBack));
    }
    if (agent.equals(AgentNames.COORDINATOR) || deployer.wasHandedOver(agent)) {
      return;
    }
    if (agent.startsWith(AgentNames.ofHost(""))) {
      rescue.gone(agent.substring(AgentNames.ofHost("").length()));
      return;
    }
    Optional<AgentStart> lost = deployer.ended(agent);
    if (lost.isPresent()) {
      lives.tell(listener -> listener.agentMoves(agent));
      rescue.lost(agent, TakeoverLinks.controller(lost.get().container()));
    } else {
      lives.tell(listener -> listener.agentEnded(agent));
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

  @Override
  public void agentHangs(String agent) {
    if (deployer.deployment().find(agent).isEmpty()) {
      return;
    }
    LOG.warn("The agent of {} hangs; another takes its place", agent);
    beside(
        () -> {
          lives.tell(listener -> listener.agentMoves(agent));
          try {
            deployer.replace(agent, container -> signs.end(container, agent));
          } catch (RuntimeException e) {
            LOG.warn("The agent of {} gets no other: {}", agent, e.getMessage());
          }
        });
  }
}
