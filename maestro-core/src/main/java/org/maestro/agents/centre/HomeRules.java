package org.maestro.agents.centre;

import java.time.Duration;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Rule;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The rules of the home's file, which are held from the start on: once the home's devices have told
 * of themselves, so that nothing counts as having happened that was so before. Agent thread only.
 */
public final class HomeRules {
  private static final Logger LOG = LoggerFactory.getLogger(HomeRules.class);

  /** Who has come tells of itself within this time. */
  private static final Duration TELLING = Duration.ofSeconds(1);

  private final MaestroAgent agent;
  private final Home home;
  private final GoalRequests requests;
  private final Set<String> awaited;
  private boolean areHeld;

  /**
   * @param home as its file describes it
   */
  public HomeRules(MaestroAgent agent, Home home, GoalRequests requests) {
    this.agent = agent;
    this.home = home;
    this.requests = requests;
    this.awaited = new TreeSet<>(home.devices().keySet());
  }

  /**
   * They are awaited from now on.
   *
   * @param patience simulated time for which devices that stay away are waited for
   */
  public void begin(Duration patience) {
    if (!home.rules().isEmpty()) {
      holdIn(patience);
    }
  }

  /** Somebody is there, who need not be a device of the home. */
  public void memberPresent(String member) {
    if (awaited.remove(member) && awaited.isEmpty() && !home.rules().isEmpty()) {
      holdIn(TELLING);
    }
  }

  private void holdIn(Duration time) {
    agent.clock().schedule(time, agent.getLocalName(), () -> agent.tell(this::hold));
  }

  private void hold() {
    if (areHeld) {
      return;
    }
    areHeld = true;
    home.rules().values().forEach(this::hold);
  }

  private void hold(Rule rule) {
    try {
      requests.hold(rule);
    } catch (InvalidGoalException e) {
      LOG.warn("The rule {} is not held: {}", rule.name(), e.getMessage());
    }
  }
}
