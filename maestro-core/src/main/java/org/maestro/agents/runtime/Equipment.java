package org.maestro.agents.runtime;

import jade.core.Agent;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.function.BooleanSupplier;
import org.maestro.agents.references.References;
import org.maestro.agents.stepping.IdleDetector;
import org.maestro.agents.stepping.WorkTickets;

/** The working parts of an agent in one container; it gets others when it moves. */
final class Equipment {
  final AgentTime time;
  final WorkTickets tickets;
  final CountDownLatch started = new CountDownLatch(1);
  final IdleDetector idleDetector;
  final Conversations conversations;
  final References references;
  final NotUnderstoodReplier protest;
  final Inbox inbox;
  final Reception reception;

  /**
   * @param thread the agent's own
   * @param mail takes one message; returns whether there was one
   */
  Equipment(Agent agent, OwnThread thread, AgentTime time, BooleanSupplier mail) {
    this.time = time;
    this.tickets = new WorkTickets(time.clock(), agent.getClass().getSimpleName());
    this.idleDetector = new IdleDetector(tickets, started::countDown);
    this.conversations = new Conversations(agent, thread, time);
    this.references = new References(new AgentPost(agent, thread, time));
    this.protest = new NotUnderstoodReplier(agent);
    this.inbox = new Inbox(agent, thread, time.clock(), tickets);
    this.reception =
        new Reception(
            agent, List.of(inbox::step, conversations::step, mail), inbox::hasWork, this::settled);
  }

  /**
   * On a stepped clock it is looked again whether the agent is idle, as a waking by JADE can be
   * lost; where time is paced nobody waits until it is, but for its start.
   */
  private void settled() {
    if (time.clock().isStepped()) {
      idleDetector.restart();
    } else {
      tickets.idle();
      started.countDown();
    }
  }
}
