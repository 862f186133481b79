package org.maestro.platform;

import java.util.function.BiConsumer;
import java.util.function.Function;
import org.maestro.agents.PersonTrackerAgent;
import org.maestro.agents.lives.AgentLifeListener;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The agent that follows persons, of which a platform has one if its home says so: when it ends,
 * another begins in its place. Any thread may call.
 */
final class TrackerInService implements AgentLifeListener {
  private static final Logger LOG = LoggerFactory.getLogger(TrackerInService.class);

  private final String name;
  private final Clock clock;
  private final Function<String, PersonTrackerAgent> making;
  private final BiConsumer<String, MaestroAgent> starting;
  private volatile boolean over;

  /**
   * @param making makes an agent of that name
   * @param starting has it begin, and waits until it has
   */
  TrackerInService(
      String name,
      Clock clock,
      Function<String, PersonTrackerAgent> making,
      BiConsumer<String, MaestroAgent> starting) {
    this.name = name;
    this.clock = clock;
    this.making = making;
    this.starting = starting;
  }

  void begin() {
    starting.accept(name, making.apply(name));
  }

  /** None begins any more. */
  void end() {
    over = true;
  }

  /** JADE tells it, and must not be held up. */
  @Override
  public void agentDied(String agent) {
    if (agent.equals(name) && !over) {
      LOG.warn("The agent {} ended; another follows the persons in its place", name);
      Clock.Ticket ticket = clock.hold("the next " + name);
      Thread starter = new Thread(() -> beginAgain(ticket), "agent-starter");
      starter.setDaemon(true);
      starter.start();
    }
  }

  private void beginAgain(Clock.Ticket ticket) {
    try {
      begin();
    } catch (PlatformStartException e) {
      if (!over) {
        LOG.warn("Nobody follows the persons: {}", e.getMessage());
      }
    } finally {
      ticket.close();
    }
  }
}
