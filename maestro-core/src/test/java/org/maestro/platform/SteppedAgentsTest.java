package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.proto.ContractNetInitiator;
import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Vector;
import java.util.stream.LongStream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.fixtures.Share;
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.Sockets;
import org.maestro.rats.time.SteppedClock;

/**
 * Real JADE agents on the stepped clock: the same seed gives the same events, whatever else the
 * machine does.
 */
class SteppedAgentsTest {
  private static final int ROUNDS = 4;

  @TempDir static Path files;
  private static AgentContainer main;
  private static AgentContainer second;

  @BeforeAll
  static void startJade() {
    int port = Sockets.claim(0);
    main = JadeRuntime.main("stepped-agents", port, files);
    second =
        JadeRuntime.join(
            Optional.of("stepped-agents"),
            "127.0.0.1",
            port,
            "second",
            files,
            JadeRuntime.Entry.OPEN);
  }

  @AfterAll
  static void endJade() {
    ContainerEnds.end(second);
    ContainerEnds.end(main);
  }

  @Test
  void sameSeedSameEvents() throws Exception {
    assertSameEvents(LongStream.range(1, 20));
  }

  @Test
  @Tag("full")
  void sameSeedSameEventsOnALoadedMachine() throws Exception {
    List<Thread> load = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      Thread thread = new Thread(SteppedAgentsTest::burn, "load-" + i);
      thread.start();
      load.add(thread);
    }
    try {
      assertSameEvents(Share.of(LongStream.range(1, 200)));
    } finally {
      load.forEach(Thread::interrupt);
    }
  }

  @Test
  void anotherSeedGivesOtherEvents() throws Exception {
    assertThat(run(1_000, 2)).isNotEqualTo(run(1_001, 1));
  }

  private static void assertSameEvents(LongStream runs) throws Exception {
    List<String> first = run(0, 1);
    assertThat(first).hasSizeGreaterThan(ROUNDS * 8);
    for (long number : runs.toArray()) {
      assertThat(run((int) number, 1)).as("run %d", number).isEqualTo(first);
    }
  }

  private static boolean isContractNet(ACLMessage message) {
    return FIPANames.InteractionProtocol.FIPA_CONTRACT_NET.equals(message.getProtocol());
  }

  private static void burn() {
    double value = 1;
    while (!Thread.currentThread().isInterrupted()) {
      value = Math.sin(value) + 1;
    }
  }

  /** One run of the toy exchange; returns its event log. */
  private static List<String> run(int number, long seed) throws Exception {
    SteppedClock clock = new SteppedClock();
    AgentTime time = AgentTime.of(clock);
    List<String> log = Collections.synchronizedList(new ArrayList<>());
    List<AgentController> agents = new ArrayList<>();
    List<AID> bidders = new ArrayList<>();
    for (int i = 0; i < 3; i++) {
      Bidder bidder =
          new Bidder(Birth.of(main), time, "bidder" + i, new Random(seed * 31 + i), log);
      agents.add(JadeRuntime.start(i == 0 ? main : second, "r" + number + "b" + i, bidder));
      bidders.add(bidder.getAID());
    }
    Caller caller = new Caller(Birth.of(main), time, bidders, log);
    agents.add(JadeRuntime.start(main, "r" + number + "caller", caller));
    caller.tell(caller::nextRound);

    boolean ended = clock.runUntil(() -> caller.rounds > ROUNDS, Duration.ofMinutes(10));
    log.add(clock.now() + " ended " + ended);
    for (AgentController agent : agents) {
      agent.kill();
    }
    return List.copyOf(log);
  }

  /** Calls for proposals, accepts the lowest, and starts over. */
  private static final class Caller extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final transient List<AID> bidders;
    private final transient List<String> log;
    private volatile int rounds = 1;

    Caller(Birth birth, AgentTime time, List<AID> bidders, List<String> log) {
      super(birth, time);
      this.bidders = bidders;
      this.log = log;
    }

    @Override
    protected boolean expects(ACLMessage message) {
      return isContractNet(message);
    }

    @Override
    protected void received(ACLMessage message) {
      log.add(clock().now() + " caller got " + message.getContent());
    }

    void nextRound() {
      ACLMessage cfp = new ACLMessage(ACLMessage.CFP);
      bidders.forEach(cfp::addReceiver);
      cfp.setProtocol(FIPANames.InteractionProtocol.FIPA_CONTRACT_NET);
      cfp.setContent("round" + rounds);
      addBehaviour(
          new ContractNetInitiator(this, cfp) {
            private static final long serialVersionUID = 1L;

            @Override
            @SuppressWarnings({"rawtypes", "unchecked"})
            protected void handleAllResponses(Vector responses, Vector acceptances) {
              ACLMessage best = null;
              for (Object response : responses) {
                ACLMessage bid = (ACLMessage) response;
                log.add(clock().now() + " bid " + bid.getContent());
                if (best == null
                    || Integer.parseInt(bid.getContent()) < Integer.parseInt(best.getContent())) {
                  best = bid;
                }
              }
              for (Object response : responses) {
                ACLMessage decision = ((ACLMessage) response).createReply();
                decision.setPerformative(
                    response == best ? ACLMessage.ACCEPT_PROPOSAL : ACLMessage.REJECT_PROPOSAL);
                acceptances.add(decision);
              }
            }

            @Override
            protected void handleInform(ACLMessage inform) {
              log.add(clock().now() + " done " + inform.getContent());
              rounds++;
              if (rounds <= ROUNDS) {
                nextRound();
              }
            }
          });
    }
  }

  /** Answers after a random time, and works for a random time. */
  private static final class Bidder extends MaestroAgent {
    private static final long serialVersionUID = 1L;
    private final String label;
    private final transient Random random;
    private final transient List<String> log;

    Bidder(Birth birth, AgentTime time, String label, Random random, List<String> log) {
      super(birth, time);
      this.label = label;
      this.random = random;
      this.log = log;
    }

    @Override
    protected void setup() {
      super.setup();
      addBehaviour(
          new jade.core.behaviours.CyclicBehaviour(this) {
            private static final long serialVersionUID = 1L;

            @Override
            public void action() {
              ACLMessage message =
                  receive(
                      jade.lang.acl.MessageTemplate.MatchProtocol(
                          FIPANames.InteractionProtocol.FIPA_CONTRACT_NET));
              if (message == null) {
                block();
              } else {
                heard(message);
              }
            }
          });
    }

    private void heard(ACLMessage message) {
      log.add(
          clock().now()
              + " "
              + label
              + " heard "
              + ACLMessage.getPerformative(message.getPerformative()));
      if (message.getPerformative() == ACLMessage.CFP) {
        answerLater(message, ACLMessage.PROPOSE, String.valueOf(random.nextInt(1_000)));
      } else if (message.getPerformative() == ACLMessage.ACCEPT_PROPOSAL) {
        answerLater(message, ACLMessage.INFORM, label);
      }
    }

    private void answerLater(ACLMessage message, int performative, String content) {
      clock()
          .schedule(
              Duration.ofMillis(random.nextInt(5)),
              label,
              () ->
                  tell(
                      () -> {
                        ACLMessage answer = message.createReply();
                        answer.setPerformative(performative);
                        answer.setContent(content);
                        send(answer);
                      }));
    }

    @Override
    protected boolean expects(ACLMessage message) {
      return isContractNet(message);
    }

    @Override
    protected void received(ACLMessage message) {
      log.add(clock().now() + " " + label + " got " + Words.print());
    }
  }
}
