package org.maestro.agents;

import jade.lang.acl.ACLMessage;
import java.util.concurrent.atomic.AtomicBoolean;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.persons.PersonTracker;
import org.maestro.rats.time.Clock;

/**
 * The agent that follows the persons of a home, one for all of its rooms (ADE, 5; A2, A74). It
 * hears by the collective knowledge what all rooms' devices notice, and tells it where everybody
 * probably is; whoever wants to know that asks there. One in the place of another begins with what
 * is known, and with what was counted.
 */
public final class PersonTrackerAgent extends MaestroAgent {
  private static final long serialVersionUID = 1L;

  private final transient KnowledgeBase knowledge;
  private final transient PersonTracker tracker;
  private final transient AtomicBoolean isToLook = new AtomicBoolean();
  private transient Clock.Timer next = () -> {};

  /**
   * An agent that begins to follow them when JADE has it begin.
   *
   * @param name the agent's, as which source it tells what it believes
   * @param log remembers who went where
   */
  public PersonTrackerAgent(
      Birth birth, AgentTime time, KnowledgeBase knowledge, String name, HabitLog log) {
    super(birth, time);
    this.knowledge = knowledge;
    this.tracker = new PersonTracker(name, knowledge, time.clock(), log);
  }

  @Override
  protected void setup() {
    super.setup();
    tracker.begin();
    knowledge.watch(
        change -> {
          if (tracker.concerns(change) && isToLook.compareAndSet(false, true)) {
            tell(this::look);
          }
        });
    lookAgain();
  }

  @Override
  protected void takeDown() {
    next.cancel();
    super.takeDown();
  }

  private void look() {
    isToLook.set(false);
    tracker.look();
  }

  private void lookAgain() {
    next =
        clock()
            .schedule(
                PersonTracker.BETWEEN_LOOKS,
                getLocalName(),
                () ->
                    tell(
                        () -> {
                          look();
                          lookAgain();
                        }));
  }

  @Override
  protected void received(ACLMessage message) {
    refuse(
        message,
        ACLMessage.NOT_UNDERSTOOD,
        "The person tracker tells the agent %s what it believes; ask there."
            .formatted(AgentNames.KNOWLEDGE));
  }
}
