package org.maestro.platform.jade;

import jade.core.AID;
import jade.core.AgentContainer;
import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The witness of what the agents in the containers that one platform has in this process send, and
 * of what reaches them from elsewhere. While nobody listens it looks at nothing. Any thread may
 * call.
 */
public final class MailWitness {
  private static final Logger LOG = LoggerFactory.getLogger(MailWitness.class);

  /** Where a container's profile holds the one that it shares with others. */
  static final String KEY = "maestro-mail-witness";

  private final List<AgentContainer> containers = new CopyOnWriteArrayList<>();
  private final List<Consumer<SentMessage>> listeners = new CopyOnWriteArrayList<>();

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

  /** What an agent of one of these containers has sent was seen when it did. */
  void delivered(AID sender, ACLMessage message, AID receiver) {
    if (!listeners.isEmpty()
        && containers.stream().noneMatch(container -> container.isLocalAgent(sender))) {
      sent(sender, message, receiver);
    }
  }
}
