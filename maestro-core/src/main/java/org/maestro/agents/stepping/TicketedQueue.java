package org.maestro.agents.stepping;

import jade.core.MessageQueue;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.util.leap.List;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * An agent's message queue that tells when a message is taken out, and whether any is there of a
 * conversation. Any thread may ask; JADE guards what it does with it by its own lock.
 */
public final class TicketedQueue implements MessageQueue {
  private final Deque<ACLMessage> messages = new ArrayDeque<>();
  private final Map<String, Integer> ofConversation = new HashMap<>();
  private final WorkTickets tickets;

  public TicketedQueue(WorkTickets tickets) {
    this.tickets = tickets;
  }

  @Override
  public synchronized void addFirst(ACLMessage message) {
    messages.addFirst(message);
    ofConversation.merge(conversation(message), 1, Integer::sum);
  }

  @Override
  public synchronized void addLast(ACLMessage message) {
    messages.addLast(message);
    ofConversation.merge(conversation(message), 1, Integer::sum);
  }

  private static String conversation(ACLMessage message) {
    return String.valueOf(message.getConversationId());
  }

  /** Whether a message of the conversation waits to be taken out. */
  public synchronized boolean hasAnyOf(String conversation) {
    return ofConversation.containsKey(conversation);
  }

  @Override
  public int getMaxSize() {
    return 0;
  }

  /**
   * JADE sets its default, no bound; there is no other here, as a dropped message would keep its
   * ticket.
   */
  @Override
  public void setMaxSize(int size) {
    if (size != 0) {
      throw new IllegalArgumentException("The queue of a MAESTRO agent has no bound to set.");
    }
  }

  @Override
  public synchronized boolean isEmpty() {
    return messages.isEmpty();
  }

  @Override
  public synchronized @Nullable ACLMessage receive(MessageTemplate pattern) {
    for (Iterator<ACLMessage> iterator = messages.iterator(); iterator.hasNext(); ) {
      ACLMessage message = iterator.next();
      if (pattern == null || pattern.match(message)) {
        iterator.remove();
        ofConversation.computeIfPresent(
            conversation(message), (id, number) -> number > 1 ? number - 1 : null);
        tickets.taken(message);
        return message;
      }
    }
    return null;
  }

  @Override
  public synchronized void copyTo(List list) {
    messages.forEach(list::add);
  }

  @Override
  public synchronized int size() {
    return messages.size();
  }
}
