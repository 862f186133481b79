package org.maestro.agents.stepping;

import jade.core.MessageQueue;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.util.leap.List;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;

/**
 * An agent's message queue that tells when a message is taken out. JADE guards it by its own lock.
 */
public final class TicketedQueue implements MessageQueue {
  private final Deque<ACLMessage> messages = new ArrayDeque<>();
  private final WorkTickets tickets;

  public TicketedQueue(WorkTickets tickets) {
    this.tickets = tickets;
  }

  @Override
  public synchronized void addFirst(ACLMessage message) {
    messages.addFirst(message);
  }

  @Override
  public synchronized void addLast(ACLMessage message) {
    messages.addLast(message);
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
  public synchronized ACLMessage receive(MessageTemplate pattern) {
    for (Iterator<ACLMessage> iterator = messages.iterator(); iterator.hasNext(); ) {
      ACLMessage message = iterator.next();
      if (pattern == null || pattern.match(message)) {
        iterator.remove();
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
