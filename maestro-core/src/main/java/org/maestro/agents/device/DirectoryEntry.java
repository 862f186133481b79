package org.maestro.agents.device;

import jade.lang.acl.ACLMessage;
import java.io.Serializable;
import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.YellowPages;
import org.maestro.ontology.home.Device;

/**
 * A generic agent's entry in the yellow pages: whether it has one, and how it gets it; it takes
 * along that it has one when it moves. Agent thread only.
 */
public final class DirectoryEntry implements Serializable {
  private static final long serialVersionUID = 1L;
  private static final Duration ANSWER_WITHIN = Duration.ofSeconds(30);
  private static final Duration TRY_AGAIN = Duration.ofMillis(500);
  private static final int MOST_ATTEMPTS = 10;
  private static final int PATIENT_ATTEMPTS = 6;

  private boolean registered;

  /**
   * Makes the entry what it has to be now.
   *
   * @param offering what the members are that can be used, by id
   */
  public void renew(MaestroAgent agent, Supplier<Map<String, Device>> offering) {
    renew(agent, offering, 1);
  }

  private void renew(MaestroAgent agent, Supplier<Map<String, Device>> offering, int attempt) {
    Map<String, Device> now = offering.get();
    boolean before = registered;
    Optional<ACLMessage> request = YellowPages.request(agent, now, before);
    registered = !now.isEmpty();
    if (agent.clock().isStepped()) {
      request.ifPresent(agent::send);
    } else {
      request.ifPresent(
          message ->
              agent.ask(
                  message,
                  ANSWER_WITHIN,
                  receipt -> registeredOrNot(agent, offering, receipt, before, attempt)));
    }
  }

  /**
   * An entry of an agent of this name that has just died may be there still, and goes in a moment;
   * or it has been removed meanwhile. If it does not go it is taken over.
   */
  private void registeredOrNot(
      MaestroAgent agent,
      Supplier<Map<String, Device>> offering,
      ACLMessage receipt,
      boolean before,
      int attempt) {
    boolean failed =
        receipt.getPerformative() == ACLMessage.FAILURE
            || receipt.getPerformative() == ACLMessage.REFUSE;
    if (failed && attempt < MOST_ATTEMPTS) {
      registered = !before && attempt > PATIENT_ATTEMPTS;
      agent
          .clock()
          .schedule(
              agent.patience(TRY_AGAIN),
              agent.getLocalName(),
              () -> agent.tell(() -> renew(agent, offering, attempt + 1)));
    }
  }
}
