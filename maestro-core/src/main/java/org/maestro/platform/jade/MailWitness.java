package org.maestro.platform.jade;

import jade.core.AID;
import jade.core.AgentContainer;
import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.maestro.rats.time.HybridClock;
import org.maestro.rats.time.HybridStamp;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The witness of what the agents in the containers that one platform has in this process send, and
 * of what reaches them from elsewhere. What goes to another process carries the time of this one's
 * hybrid clock, so that logs can be put in order (ADE, 3.3; A43). Any thread may call.
 */
public final class MailWitness {
  private static final Logger LOG = LoggerFactory.getLogger(MailWitness.class);

  /** Where a container's profile holds the one that it shares with others. */
  static final String KEY = "maestro-mail-witness";

  /** The slot of a message in which its receiver's process reads when it was sent. */
  static final String TIME_SLOT = "X-maestro-time";

  private final HybridClock clock;
  private final List<AgentContainer> containers = new CopyOnWriteArrayList<>();
  private final List<Consumer<SentMessage>> listeners = new CopyOnWriteArrayList<>();

  /**
   * @param clock of this process
   */
  public MailWitness(HybridClock clock) {
    this.clock = clock;
  }

  /**
   * Tells the listener of each message from now on, on the thread that sends or delivers it, which
   * must not be held up.
   *
   * @return ends it
   */
  public Runnable listen(Consumer<SentMessage> listener) {
    listeners.add(listener);
    return () -> listeners.remove(listener);
  }

  /** The containers that are seen, by name. */
  public Set<String> containers() {
    return containers.stream()
        .map(container -> container.getID().getName())
        .collect(Collectors.toUnmodifiableSet());
  }

  void begin(AgentContainer container) {
    containers.add(container);
  }

  void end(AgentContainer container) {
    containers.remove(container);
  }

  void sent(AID sender, ACLMessage message, AID receiver) {
    if (!isHere(receiver)) {
      message.addUserDefinedParameter(TIME_SLOT, clock.now().toString());
    }
    tell(sender, message, receiver);
  }

  /** What an agent of one of these containers has sent was seen when it did. */
  void delivered(AID sender, ACLMessage message, AID receiver) {
    if (!isHere(sender)) {
      Optional.ofNullable(message.getUserDefinedParameter(TIME_SLOT))
          .flatMap(HybridStamp::read)
          .ifPresent(clock::received);
      tell(sender, message, receiver);
    }
  }

  private boolean isHere(AID agent) {
    return containers.stream().anyMatch(container -> container.isLocalAgent(agent));
  }

  private void tell(AID sender, ACLMessage message, AID receiver) {
    if (!listeners.isEmpty()) {
      try {
        SentMessage told = SentMessage.of(sender, message, receiver);
        listeners.forEach(listener -> listener.accept(told));
      } catch (RuntimeException e) {
        // Who only looks on keeps no message from its receiver.
        LOG.error("A message of {} could not be shown", sender, e);
      }
    }
  }
}
