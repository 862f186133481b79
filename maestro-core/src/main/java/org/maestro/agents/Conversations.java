package org.maestro.agents;

import jade.core.behaviours.CyclicBehaviour;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;

/**
 * The requests an agent has made and waits for. Each gets its replies, and an end: a final reply,
 * or a FAILURE of our own when the time is up. Agent thread only.
 */
final class Conversations extends CyclicBehaviour {
  private static final long serialVersionUID = 1L;

  private record Open(Consumer<ACLMessage> listener, boolean lasting, Clock.Timer timer) {}

  private final transient Map<String, Open> open = new HashMap<>();
  private final transient MaestroAgent agent;
  private final transient Clock clock;
  private int number;

  Conversations(MaestroAgent agent, Clock clock) {
    super(agent);
    this.agent = agent;
    this.clock = clock;
  }

  /**
   * Sends the request; AGREE and the final reply go to the listener.
   *
   * @param timeout of wall time on a fast clock: messages do not travel faster on it
   */
  String ask(ACLMessage request, Duration timeout, Consumer<ACLMessage> listener) {
    String id = begin(request);
    Duration limit = Duration.ofMillis((long) (timeout.toMillis() * Math.max(1, clock.speed())));
    Clock.Timer timer =
        clock.schedule(limit, agent.getLocalName(), () -> agent.tell(() -> timedOut(id, timeout)));
    open.put(id, new Open(listener, false, timer));
    agent.send(request);
    return id;
  }

  /** Sends the request; all replies go to the listener for good. */
  String subscribe(ACLMessage request, Consumer<ACLMessage> listener) {
    String id = begin(request);
    open.put(id, new Open(listener, true, () -> {}));
    agent.send(request);
    return id;
  }

  private String begin(ACLMessage request) {
    String id = agent.getLocalName() + "-" + ++number;
    request.setConversationId(id);
    request.setReplyWith(id);
    return id;
  }

  boolean isOpen(String conversationId) {
    return conversationId != null && open.containsKey(conversationId);
  }

  @Override
  public void action() {
    ACLMessage message = agent.receive(new MessageTemplate(m -> isOpen(m.getConversationId())));
    if (message == null) {
      block();
      return;
    }
    Open conversation = open.get(message.getConversationId());
    if (!conversation.lasting() && isFinal(message)) {
      conversation.timer().cancel();
      open.remove(message.getConversationId());
    }
    conversation.listener().accept(message);
  }

  private void timedOut(String id, Duration timeout) {
    Open conversation = open.remove(id);
    if (conversation != null) {
      ACLMessage failure = new ACLMessage(ACLMessage.FAILURE);
      failure.setConversationId(id);
      failure.setContent(
          Words.print(
              Words.content(
                  "inform",
                  Words.named(
                      "problem", Words.text("no answer within " + timeout.toSeconds() + " s")))));
      conversation.listener().accept(failure);
    }
  }

  /** Whether nobody replied in time; such a reply is our own, and has no sender. */
  static boolean isOverdue(ACLMessage reply) {
    return reply.getSender() == null;
  }

  private static boolean isFinal(ACLMessage message) {
    return message.getPerformative() != ACLMessage.AGREE;
  }
}
