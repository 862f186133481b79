package org.maestro.platform.failover;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import org.maestro.agents.lives.AgentLives;
import org.maestro.agents.pulse.Condition;
import org.maestro.agents.pulse.Pulse;
import org.maestro.agents.pulse.Watcher;
import org.maestro.platform.wires.Wires;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The reaction to containers and agents that fall silent: nothing is asked of whoever is suspected;
 * a container that is lost is cut off, whereupon JADE tells of its agents' ends as if it had been
 * killed.
 */
final class FailureHandler implements Watcher {
  private static final Logger LOG = LoggerFactory.getLogger(FailureHandler.class);

  private final Pulse pulse;
  private final Wires wires;
  private final Supplier<Map<String, String>> containerByAgent;
  private final AgentLives lives;

  /**
   * @param wires to containers of other processes
   * @param containerByAgent as they are at the time
   */
  FailureHandler(
      Pulse pulse, Wires wires, Supplier<Map<String, String>> containerByAgent, AgentLives lives) {
    this.pulse = pulse;
    this.wires = wires;
    this.containerByAgent = containerByAgent;
    this.lives = lives;
  }

  @Override
  public void container(String name, Condition now, Duration silence) {
    switch (now) {
      case ALIVE -> {
        LOG.info("The container {} gives signs of life again", name);
        agentsIn(name).forEach(this::trusted);
      }
      case SUSPECTED -> {
        String reason =
            "the container %s has given no sign of life for %s".formatted(name, seconds(silence));
        LOG.warn("Nothing is asked of the agents there until it does: {}", reason);
        agentsIn(name).forEach(agent -> doubted(agent, reason));
      }
      case LOST -> {
        LOG.warn(
            "The container {} is lost: it has given no sign of life for {}",
            name,
            seconds(silence));
        pulse.addresses(name).forEach(wires::cut);
      }
    }
  }

  @Override
  public void agent(String agent, Condition now, Duration silence) {
    switch (now) {
      case ALIVE -> trusted(agent);
      case LOST -> lives.tell(listener -> listener.agentHangs(agent));
      case SUSPECTED -> {
        String reason =
            "the agent of %s has done nothing for %s".formatted(agent, seconds(silence));
        LOG.warn("Nothing is asked of it until it does: {}", reason);
        doubted(agent, reason);
      }
    }
  }

  private void trusted(String agent) {
    lives.tell(listener -> listener.agentTrusted(agent));
  }

  private void doubted(String agent, String reason) {
    lives.tell(listener -> listener.agentDoubted(agent, reason));
  }

  private List<String> agentsIn(String container) {
    return containerByAgent.get().entrySet().stream()
        .filter(place -> place.getValue().equals(container))
        .map(Map.Entry::getKey)
        .toList();
  }

  private static String seconds(Duration silence) {
    return String.format(Locale.ROOT, "%.1f s", silence.toMillis() / 1000.0);
  }
}
