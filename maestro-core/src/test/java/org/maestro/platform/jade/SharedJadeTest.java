package org.maestro.platform.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.core.Agent;
import jade.core.behaviours.OneShotBehaviour;
import jade.lang.acl.ACLMessage;
import jade.wrapper.AgentContainer;
import java.nio.file.Path;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Platforms that follow each other closely in one process. */
class SharedJadeTest {
  private static final int PLATFORMS = 4;

  /**
   * What delivers messages ends with the last container. It takes JADE three seconds to end one
   * that is young.
   */
  @Test
  @Tag("full")
  void messagesArriveInAPlatformThatBeginsWhileTheLastOneEnds(@TempDir Path files)
      throws Exception {
    AgentContainer before = JadeRuntime.main("platform-0", Sockets.claim(0), files);
    for (int number = 1; number <= PLATFORMS; number++) {
      Thread ending = new Thread(endOf(before), "ending");
      ending.start();
      while (before.isJoined()) {
        Thread.onSpinWait();
      }
      AgentContainer main = JadeRuntime.main("platform-" + number, Sockets.claim(0), files);
      CountDownLatch arrived = new CountDownLatch(1);
      main.acceptNewAgent("hearing", new Hearing(arrived)).start();
      main.acceptNewAgent("speaking", new Speaking()).start();

      assertThat(arrived.await(10, TimeUnit.SECONDS)).as("platform %d", number).isTrue();
      ending.join();
      before = main;
    }
    // It is so young that JADE's own agents still write into the folder, which goes with the test.
    ContainerEnds.endNow(before);
  }

  private static Runnable endOf(AgentContainer container) {
    return () -> ContainerEnds.endNow(container);
  }

  private static final class Hearing extends Agent {
    private static final long serialVersionUID = 1L;
    private final transient CountDownLatch arrived;

    private Hearing(CountDownLatch arrived) {
      this.arrived = arrived;
    }

    @Override
    protected void setup() {
      addBehaviour(
          new OneShotBehaviour(this) {
            private static final long serialVersionUID = 1L;

            @Override
            public void action() {
              blockingReceive();
              arrived.countDown();
            }
          });
    }
  }

  private static final class Speaking extends Agent {
    private static final long serialVersionUID = 1L;

    @Override
    protected void setup() {
      ACLMessage message = new ACLMessage(ACLMessage.INFORM);
      message.addReceiver(new AID("hearing", AID.ISLOCALNAME));
      send(message);
    }
  }
}
