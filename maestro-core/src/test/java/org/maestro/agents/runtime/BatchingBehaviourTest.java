package org.maestro.agents.runtime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.core.Agent;
import jade.core.behaviours.SimpleBehaviour;
import jade.lang.acl.ACLMessage;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.platform.BareJade;
import org.maestro.platform.Hearing;

/** A conversation's behaviour among the other messages of its agent. */
class BatchingBehaviourTest {
  private static final int ACTIONS = 10;

  @TempDir Path files;

  private final AtomicBoolean hasMail = new AtomicBoolean();
  private final AtomicInteger heard = new AtomicInteger();
  private final Working working = new Working();

  /** Has some actions to do each time that it is woken. */
  private static final class Working extends SimpleBehaviour {
    private static final long serialVersionUID = 1L;
    private final transient AtomicInteger actions = new AtomicInteger();
    private boolean ended;

    @Override
    public void action() {
      if (actions.incrementAndGet() % ACTIONS == 0) {
        block();
      }
    }

    @Override
    public boolean done() {
      return ended;
    }
  }

  private final class Talking extends Agent {
    private static final long serialVersionUID = 1L;

    @Override
    protected void setup() {
      addBehaviour(new BatchingBehaviour(working, hasMail::get));
      addBehaviour(new Hearing(this, message -> heard.incrementAndGet()));
    }
  }

  @Test
  void restsUntilThereIsMailOfItsConversationAndThenDoesAllThereIsToDo() throws Exception {
    try (BareJade jade = new BareJade("in-one-go", files)) {
      Talking agent = new Talking();
      jade.main().acceptNewAgent("talking", agent).start();
      await().until(() -> working.actions.get() == ACTIONS);

      agent.postMessage(new ACLMessage(ACLMessage.INFORM));
      await().until(() -> heard.get() == 1);
      assertThat(working.actions).hasValue(ACTIONS);

      hasMail.set(true);
      agent.postMessage(new ACLMessage(ACLMessage.INFORM));
      await().until(() -> working.actions.get() == 2 * ACTIONS);

      hasMail.set(false);
      working.restart();
      await().until(() -> working.actions.get() == 3 * ACTIONS);
    }
  }

  @Test
  void endsWithItsBehaviour() throws Exception {
    try (BareJade jade = new BareJade("in-one-go", files)) {
      working.ended = true;
      Talking agent = new Talking();
      jade.main().acceptNewAgent("talking", agent).start();
      agent.postMessage(new ACLMessage(ACLMessage.INFORM));
      await().until(() -> heard.get() == 1);
      assertThat(working.actions).hasValue(1);
    }
  }
}
