package org.maestro.agents.runtime;

import jade.core.AID;
import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.rats.bounded.BoundedMap;
import org.maestro.rats.time.Clock;

/**
 * The requests an agent has made and waits for. Each gets its replies, and an end: a final reply,
 * or a FAILURE of our own when the time is up. What comes later is told apart from other mail for a
 * while. Agent thread only.
 */
public final class Conversations {
  private static final int REMEMBERED = 256;

  private static final class Open {
    private final AID partner;
    private final Consumer<ACLMessage> listener;
    private final Consumer<ACLMessage> late;
    private final boolean lasting;
    private Clock.Timer timer = () -> {};

    private Open(
        AID partner, Consumer<ACLMessage> listener, Consumer<ACLMessage> late, boolean lasting) {
      this.partner = partner;
      this.listener = listener;
      this.late = late;
      this.lasting = lasting;
    }
  }

  /** One that is over: nothing is kept of it but who may still answer, and who is told then. */
  private record Ended(AID partner, Consumer<ACLMessage> late) {}

  private final transient Map<String, Open> open = new HashMap<>();
  private final transient Map<String, Ended> ended = BoundedMap.ofNewest(REMEMBERED);
  private final transient Map<String, Consumer<String>> adopted = new HashMap<>();
  private final transient Agent agent;
  private final transient OwnThread thread;
  private final transient AgentTime time;
  private int number;

  Conversations(Agent agent, OwnThread thread, AgentTime time) {
    this.agent = agent;
    this.thread = thread;
    this.time = time;
  }

  /**
   * Sends the request; AGREE and the final reply go to the listener.
   *
   * @param timeout simulated time
   * @param late is told of what comes after the end
   */
  public String ask(
      ACLMessage request,
      Duration timeout,
      Consumer<ACLMessage> listener,
      Consumer<ACLMessage> late) {
    Open conversation = new Open(partner(request), listener, late, false);
    String id = begin(request, conversation);
    endAfter(id, conversation, timeout);
    agent.send(request);
    return id;
  }

  public String ask(ACLMessage request, Duration timeout, Consumer<ACLMessage> listener) {
    return ask(request, timeout, listener, reply -> {});
  }

  /** Sends the request; all replies go to the listener for good. */
  public String subscribe(ACLMessage request, Consumer<ACLMessage> listener) {
    String id = begin(request, new Open(partner(request), listener, reply -> {}, true));
    agent.send(request);
    return id;
  }

  /** From now on the conversation has so much time more. */
  public void extend(String id, Duration timeout) {
    Open conversation = open.get(id);
    if (conversation != null) {
      conversation.timer.cancel();
      endAfter(id, conversation, timeout);
    }
  }

  /** Nobody waits for the final reply any more. */
  public void close(String id) {
    Open conversation = open.remove(id);
    if (conversation != null) {
      conversation.timer.cancel();
      ended.put(id, new Ended(conversation.partner, conversation.late));
    }
  }

  /** The partner of these conversations is no more: they end as if the platform had said so. */
  public void partnerEnded(String localName, AID platform) {
    for (Map.Entry<String, Open> entry : new ArrayList<>(open.entrySet())) {
      Open conversation = entry.getValue();
      if (conversation.partner.getLocalName().equals(localName)) {
        close(entry.getKey());
        ACLMessage failure = new ACLMessage(ACLMessage.FAILURE);
        failure.setConversationId(entry.getKey());
        failure.setSender(platform);
        failure.setContent("((MTS-error " + localName + " \"There is no such agent.\"))");
        thread.work(() -> conversation.listener.accept(failure));
      }
    }
    List.copyOf(adopted.values()).forEach(leader -> leader.accept(localName));
  }

  /** A conversation that a behaviour of its own leads: its messages are left to that. */
  public void adopt(String id) {
    adopt(id, partner -> {});
  }

  /**
   * The same.
   *
   * @param partnerEnded is told the local name of each partner of this agent that is no more
   */
  public void adopt(String id, Consumer<String> partnerEnded) {
    adopted.put(id, partnerEnded);
  }

  public void leave(String id) {
    adopted.remove(id);
    thread.wake();
  }

  private static AID partner(ACLMessage request) {
    return (AID) request.getAllReceiver().next();
  }

  private String begin(ACLMessage request, Open conversation) {
    String id = agent.getLocalName() + "-" + ++number;
    request.setConversationId(id);
    request.setReplyWith(id);
    open.put(id, conversation);
    return id;
  }

  private void endAfter(String id, Open conversation, Duration timeout) {
    Clock.Timer[] timer = new Clock.Timer[1];
    timer[0] =
        time.clock()
            .schedule(
                timeout,
                agent.getLocalName(),
                () -> thread.tell(() -> timedOut(id, conversation, timer[0], timeout)));
    conversation.timer = timer[0];
  }

  /** Whether the message belongs to a conversation that somebody here leads. */
  boolean isOpen(ACLMessage message) {
    String id = message.getConversationId();
    return id != null && (adopted.containsKey(id) || isOpenWith(id, message));
  }

  private boolean isOpenWith(String id, ACLMessage message) {
    Open conversation = open.get(id);
    return conversation != null && isFrom(conversation.partner, message);
  }

  /** Whether the message answers what is over. */
  private boolean isLate(ACLMessage message) {
    String id = message.getConversationId();
    Ended conversation = ended.get(id);
    return conversation != null && isFrom(conversation.partner, message);
  }

  boolean isOurs(ACLMessage message) {
    return isOpen(message) || isLate(message);
  }

  /**
   * Nobody else may answer; but the platform does for an agent that is no more. What an agent asks
   * itself is no answer.
   */
  private static boolean isFrom(AID partner, ACLMessage message) {
    boolean isTheRequest = message.getConversationId().equals(message.getReplyWith());
    return !isTheRequest
        && (partner.equals(message.getSender()) || Replies.isFromPlatform(message));
  }

  public int openCount() {
    return open.size() + adopted.size();
  }

  /** Takes one message; returns whether there was one. */
  boolean step() {
    ACLMessage message =
        agent.receive(
            new MessageTemplate(
                m -> isOpenWith(String.valueOf(m.getConversationId()), m) || isLate(m)));
    if (message == null) {
      return false;
    }
    String id = message.getConversationId();
    Open conversation = open.get(id);
    if (conversation == null) {
      thread.work(() -> over(id).late.accept(message));
      return true;
    }
    if (!conversation.lasting && isFinal(message)) {
      close(id);
    }
    thread.work(() -> conversation.listener.accept(message));
    return true;
  }

  /** What is not open any more when an answer is taken is over. */
  private Ended over(String id) {
    return Objects.requireNonNull(ended.get(id));
  }

  private void timedOut(String id, Open conversation, Clock.Timer timer, Duration timeout) {
    if (open.get(id) == conversation && conversation.timer == timer) {
      close(id);
      ACLMessage failure = new ACLMessage(ACLMessage.FAILURE);
      failure.setConversationId(id);
      String problem = "no answer within " + Replies.seconds(time.wallTime(timeout));
      failure.setContent(
          Words.print(Words.content("inform", Words.named("problem", Words.text(problem)))));
      conversation.listener.accept(failure);
    }
  }

  /** Whether nobody replied in time; such a reply is our own, and has no sender. */
  public static boolean isOverdue(ACLMessage reply) {
    return reply.getSender() == null;
  }

  /** That something agreed on is so, or is so no longer, is news of it and not its end. */
  public static boolean isFinal(ACLMessage message) {
    return switch (message.getPerformative()) {
      case ACLMessage.AGREE, ACLMessage.CONFIRM, ACLMessage.DISCONFIRM -> false;
      default -> true;
    };
  }
}
