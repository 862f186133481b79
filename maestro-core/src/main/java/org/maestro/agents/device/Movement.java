package org.maestro.agents.device;

import jade.lang.acl.ACLMessage;
import java.io.Serializable;
import java.time.Duration;
import java.util.function.BooleanSupplier;
import org.maestro.agents.runtime.MaestroAgent;

/**
 * An agent's way to another container: it goes when nothing is under way with it, and tells who
 * asked when it is there. Travels with the agent. Agent thread only.
 */
public final class Movement implements Serializable {
  private static final long serialVersionUID = 1L;
  private static final Duration LOOK_AGAIN = Duration.ofMillis(50);
  private static final int MOST_LOOKS = 1_200;

  private final ACLMessage request;
  private final String container;
  private int looks;

  public Movement(ACLMessage request, String container) {
    this.request = request;
    this.container = container;
  }

  public ACLMessage request() {
    return request;
  }

  String container() {
    return container;
  }

  /**
   * Looks until nothing is under way any more, and then goes.
   *
   * @param givenUp done when that takes too long
   */
  public void goWhen(MaestroAgent agent, BooleanSupplier idle, Runnable givenUp) {
    if (idle.getAsBoolean()) {
      agent.goTo(container);
    } else if (++looks > MOST_LOOKS) {
      givenUp.run();
    } else {
      agent
          .clock()
          .schedule(
              agent.patience(LOOK_AGAIN),
              agent.getLocalName(),
              () -> agent.tell(() -> goWhen(agent, idle, givenUp)));
    }
  }
}
