package org.maestro.agents.references;

import jade.lang.acl.ACLMessage;
import java.util.Optional;
import org.maestro.rats.time.Clock;

/**
 * A reference that was asked for and is not there yet. The one that the registry has named may
 * answer before that name is here. Agent thread only.
 */
final class Referral {
  private final Holder holder;
  private final Clock.Timer timer;
  private Optional<String> named = Optional.empty();
  private Optional<ACLMessage> early = Optional.empty();

  /**
   * @param timer ends the waiting
   */
  Referral(Holder holder, Clock.Timer timer) {
    this.holder = holder;
    this.timer = timer;
  }

  Holder holder() {
    return holder;
  }

  void end() {
    timer.cancel();
  }

  /**
   * The registry has passed the request on.
   *
   * @return what the one that was asked for has said already
   */
  Optional<ACLMessage> passedOnTo(String agent) {
    named = Optional.of(agent);
    return early;
  }

  /** Whether the registry has named the sender; what comes too early for that is kept. */
  boolean isFromTheNamed(ACLMessage message) {
    if (named.isEmpty()) {
      early = Optional.of(message);
      return false;
    }
    return named.get().equals(message.getSender().getLocalName());
  }
}
