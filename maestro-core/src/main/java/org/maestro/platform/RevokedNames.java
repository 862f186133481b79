package org.maestro.platform;

import java.time.Duration;
import java.util.function.Predicate;
import org.maestro.agents.lives.AgentLives;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Agents go on under their own container's name when the one under which they took over is taken
 * out of the site: the broker lets nobody in under it. What is under way meanwhile is not heard of.
 */
final class RevokedNames {
  private static final Logger LOG = LoggerFactory.getLogger(RevokedNames.class);

  /** Wall time. */
  private static final Duration LOOKED_EVERY = Duration.ofSeconds(1);

  private final Deployer deployer;
  private final Predicate<String> mayBeUsed;
  private final Clock clock;
  private final AgentLives lives;

  /**
   * @param mayBeUsed whether anybody may call under a controller's name now
   * @param lives is told who begins again
   */
  RevokedNames(Deployer deployer, Predicate<String> mayBeUsed, Clock clock, AgentLives lives) {
    this.deployer = deployer;
    this.mayBeUsed = mayBeUsed;
    this.clock = clock;
    this.lives = lives;
  }

  void watch() {
    Duration wait = clock.ofWall(LOOKED_EVERY);
    clock.schedule(wait, "revoked-names", this::begin);
  }

  private void begin() {
    if (lives.areOver()) {
      return;
    }
    Thread looking = new Thread(this::look, "revoked-names");
    looking.setDaemon(true);
    looking.start();
  }

  /** JADE is waited for, so it is not for the clock's thread. */
  private void look() {
    try {
      deployer.borrowedNames().forEach(this::look);
    } finally {
      watch();
    }
  }

  private void look(String agent, String controller) {
    try {
      if (!lives.areOver() && !mayBeUsed.test(controller)) {
        LOG.warn(
            "{} is no longer one of the site: the agent of {} begins again under another name",
            controller,
            agent);
        lives.tell(listener -> listener.agentMoves(agent));
        deployer.giveBack(agent);
      }
    } catch (RuntimeException e) {
      LOG.warn("The agent of {} still calls as {}: {}", agent, controller, e.getMessage());
    }
  }
}
