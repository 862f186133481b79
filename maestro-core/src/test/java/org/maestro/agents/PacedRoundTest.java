package org.maestro.agents;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import jade.core.Agent;
import jade.lang.acl.ACLMessage;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.negotiation.AclContractNet;
import org.maestro.agents.negotiation.Contracts;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.ProtocolTimeouts;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.platform.BareJade;
import org.maestro.platform.Hearing;
import org.maestro.rats.time.PacedClock;
import org.maestro.sl.SlParser;

/**
 * Where time is paced, agents of JADE alone are waited for by wall time, however fast the clock.
 */
class PacedRoundTest {
  private static final double SPEED = 20;
  private static final Duration BID = Duration.ofMillis(600);

  @TempDir Path files;

  @Test
  void aSilentAgentOfJadeAloneCostsItsPatienceInWallTime() throws Exception {
    ProtocolTimeouts usual = ProtocolTimeouts.standard();
    ProtocolTimeouts patience =
        new ProtocolTimeouts(
            BID, usual.contract(), usual.offer(), usual.agreement(), usual.report(), usual.quote());
    BlockingQueue<ACLMessage> heard = new LinkedBlockingQueue<>();
    try (BareJade jade = new BareJade("paced-round", files);
        PacedClock clock = new PacedClock(SPEED)) {
      jade.main().acceptNewAgent("usher", new Silent(heard)).start();
      Asking asking = new Asking(jade.birth(), AgentTime.of(clock, patience));
      BareJade.start(jade.main(), "asking", asking);
      Duration begin = clock.now();
      long sent = System.currentTimeMillis();

      ContractNet.Round tender = asking.ask("usher").get(30, TimeUnit.SECONDS);

      assertThat(tender.bids()).hasSize(1);
      assertThat(tender.bids().get(0).refusal())
          .contains("did not answer the call for prices within 0.6 s");
      assertThat(clock.now().minus(begin))
          .isGreaterThanOrEqualTo(BID.multipliedBy((long) SPEED).minusMillis(20));
      assertThat(heard.take().getReplyByDate().getTime())
          .isBetween(sent, System.currentTimeMillis() + BID.toMillis());
      asking.tell(() -> tender.award(Map.of()));
      await().until(() -> asking.conversations().openCount() == 0);
    }
  }

  /** Hears everything, says nothing. */
  private static final class Silent extends Agent {
    private static final long serialVersionUID = 1L;
    private final transient BlockingQueue<ACLMessage> heard;

    Silent(BlockingQueue<ACLMessage> heard) {
      this.heard = heard;
    }

    @Override
    protected void setup() {
      addBehaviour(new Hearing(this, heard::add));
    }
  }

  private static final class Asking extends MaestroAgent {
    private static final long serialVersionUID = 1L;

    Asking(Birth birth, AgentTime time) {
      super(birth, time);
    }

    CompletableFuture<ContractNet.Round> ask(String member) {
      CompletableFuture<ContractNet.Round> closed = new CompletableFuture<>();
      AclContractNet contractNet =
          new AclContractNet(
              this, name -> Optional.of(getAID(name)), new Contracts(), (goal, sentence) -> {});
      CallForPrices call =
          new CallForPrices(
              "G1", SlParser.formula("(greeted Bob)"), Map.of(member, List.of("greet")));
      tell(() -> contractNet.callForPrices(call, closed::complete));
      return closed;
    }

    @Override
    protected void received(ACLMessage message) {
      throw new IllegalStateException("Nothing is left for here: " + message);
    }
  }
}
