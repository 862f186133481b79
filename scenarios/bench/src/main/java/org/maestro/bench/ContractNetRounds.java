package org.maestro.bench;

import jade.core.Agent;
import jade.core.Profile;
import jade.core.ProfileImpl;
import jade.core.Runtime;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.lang.acl.MessageTemplate;
import jade.proto.ContractNetInitiator;
import jade.proto.ContractNetResponder;
import jade.util.leap.Properties;
import jade.wrapper.AgentContainer;
import jade.wrapper.StaleProxyException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Vector;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.maestro.agents.PriceFair;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.assembly.SiteException;
import org.maestro.ontology.home.Device;
import org.maestro.platform.jade.Sockets;
import org.maestro.rats.time.PacedClock;

/**
 * Contract-net rounds per second: those of MAESTRO (price lists in MAESTRO-SL read and checked,
 * every wait on the clock, the winner's word awaited) and those of JADE alone, {@code
 * ContractNetInitiator} and {@code ContractNetResponder} with a number for a price. Both run one
 * round after the other in the same container of the same process. For one thread.
 *
 * @param agents that answer
 * @param ours rounds per second
 * @param plain rounds per second
 */
public record ContractNetRounds(int agents, double ours, double plain) {
  private static final long ROUND_WITHIN_SECONDS = 30;

  /** The two take turns, so that what else the machine does meets both. */
  private static final int TURNS = 10;

  /** Begins a round, and tells when it has ended. */
  private interface Rounds {
    void begin(Runnable ended);
  }

  /**
   * Measures both.
   *
   * @param devices whose agents answer, one each; each has a feature at least
   * @param files where JADE may write
   * @param warmUpRounds to let each of the two run before: as many of ours as of the plain ones, as
   *     both are slow until they are compiled
   * @param time to measure each of the two for
   */
  public static ContractNetRounds measure(
      List<Device> devices, Path files, int warmUpRounds, Duration time) {
    AgentContainer container = container(files);
    try (PacedClock clock = new PacedClock(1)) {
      Rounds ours = ours(container, devices, AgentTime.of(clock));
      Rounds plain = plain(container, devices.size());
      for (Rounds rounds : List.of(ours, plain)) {
        for (int i = 0; i < warmUpRounds; i++) {
          one(rounds);
        }
      }
      Tally oursInAll = new Tally();
      Tally plainInAll = new Tally();
      for (int turn = 0; turn < TURNS; turn++) {
        oursInAll.run(ours, time.dividedBy(TURNS));
        plainInAll.run(plain, time.dividedBy(TURNS));
      }
      return new ContractNetRounds(devices.size(), oursInAll.perSecond(), plainInAll.perSecond());
    } catch (StaleProxyException e) {
      throw new SiteException("JADE ended while contract nets were measured.", e);
    } finally {
      end(container);
    }
  }

  /** As a row of a report, JADE's own figure as its baseline. */
  BenchReport.Row row() {
    return new BenchReport.Row(
        "contract net, %d agents".formatted(agents), ours, "rounds/s", OptionalDouble.of(plain));
  }

  private static Rounds ours(AgentContainer container, List<Device> devices, AgentTime time)
      throws StaleProxyException {
    for (Device device : devices) {
      start(container, device.id(), PriceFair.seller(Birth.of(container), time, device));
    }
    PriceFair.Buyer buyer = new PriceFair.Buyer(Birth.of(container), time, devices);
    start(container, "buyer", buyer);
    return buyer::round;
  }

  private static void start(AgentContainer container, String name, MaestroAgent agent)
      throws StaleProxyException {
    container.acceptNewAgent(name, agent).start();
    try {
      if (!agent.awaitStart(Duration.ofSeconds(ROUND_WITHIN_SECONDS))) {
        throw new SiteException("The agent " + name + " did not start.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while agents started.", e);
    }
  }

  private static Rounds plain(AgentContainer container, int agents) throws StaleProxyException {
    CountDownLatch started = new CountDownLatch(agents + 1);
    PlainBuyer buyer = new PlainBuyer(agents, started);
    for (int i = 0; i < agents; i++) {
      container.acceptNewAgent("plain-" + i, new PlainSeller(i, started)).start();
    }
    container.acceptNewAgent("plain-buyer", buyer).start();
    try {
      if (!started.await(ROUND_WITHIN_SECONDS, TimeUnit.SECONDS)) {
        throw new SiteException("The plain agents did not start.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while agents started.", e);
    }
    return buyer::round;
  }

  /** Rounds one after the other, in several goes. */
  private static final class Tally {
    private long count;
    private long nanos;

    void run(Rounds rounds, Duration time) {
      long begin = System.nanoTime();
      while (System.nanoTime() - begin < time.toNanos()) {
        one(rounds);
        count++;
      }
      nanos += System.nanoTime() - begin;
    }

    double perSecond() {
      return count / (nanos / 1e9);
    }
  }

  private static void one(Rounds rounds) {
    CountDownLatch ended = new CountDownLatch(1);
    rounds.begin(ended::countDown);
    try {
      if (!ended.await(ROUND_WITHIN_SECONDS, TimeUnit.SECONDS)) {
        throw new SiteException("A contract net did not end within 30 s.");
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while contract nets were measured.", e);
    }
  }

  private static AgentContainer container(Path files) {
    System.setProperty("jade.enable.multiple.platforms", "true");
    Properties properties = new Properties();
    properties.setProperty(Profile.MAIN, "true");
    properties.setProperty(Profile.PLATFORM_ID, "bench-contract-net");
    String port = String.valueOf(Sockets.claim(0));
    properties.setProperty(Profile.LOCAL_HOST, "127.0.0.1");
    properties.setProperty(Profile.MAIN_HOST, "127.0.0.1");
    properties.setProperty(Profile.LOCAL_PORT, port);
    properties.setProperty(Profile.MAIN_PORT, port);
    properties.setProperty(Profile.DETECT_MAIN, "false");
    properties.setProperty(Profile.NO_MTP, "true");
    properties.setProperty(Profile.FILE_DIR, files + "/");
    properties.setProperty("jade_core_messaging_MessageManager_poolsize", "1");
    AgentContainer container = Runtime.instance().createMainContainer(new ProfileImpl(properties));
    if (container == null) {
      throw new SiteException("JADE could not start on port " + port + ".");
    }
    return container;
  }

  private static void end(AgentContainer container) {
    try {
      container.kill();
    } catch (StaleProxyException e) {
      throw new SiteException("JADE could not be ended.", e);
    }
  }

  /** Names its price, and does at once what it is accepted for. */
  private static final class PlainSeller extends Agent {
    private static final long serialVersionUID = 1L;
    private final int price;
    private final transient CountDownLatch started;

    PlainSeller(int price, CountDownLatch started) {
      this.price = price;
      this.started = started;
    }

    @Override
    protected void setup() {
      MessageTemplate calls =
          ContractNetResponder.createMessageTemplate(
              FIPANames.InteractionProtocol.FIPA_CONTRACT_NET);
      addBehaviour(
          new ContractNetResponder(this, calls) {
            private static final long serialVersionUID = 1L;

            @Override
            protected ACLMessage handleCfp(ACLMessage cfp) {
              return reply(cfp, ACLMessage.PROPOSE, String.valueOf(price));
            }

            @Override
            protected ACLMessage handleAcceptProposal(
                ACLMessage cfp, ACLMessage propose, ACLMessage accept) {
              return reply(accept, ACLMessage.INFORM, "done");
            }
          });
      started.countDown();
    }

    private static ACLMessage reply(ACLMessage message, int performative, String content) {
      ACLMessage reply = message.createReply();
      reply.setPerformative(performative);
      reply.setContent(content);
      return reply;
    }
  }

  /** Accepts the lowest price. */
  private static final class PlainBuyer extends Agent {
    private static final long serialVersionUID = 1L;
    private final int sellers;
    private final transient CountDownLatch started;

    PlainBuyer(int sellers, CountDownLatch started) {
      this.sellers = sellers;
      this.started = started;
    }

    @Override
    protected void setup() {
      started.countDown();
    }

    void round(Runnable ended) {
      addBehaviour(new PlainRound(this, call(), result -> ended.run()));
    }

    private ACLMessage call() {
      ACLMessage cfp = new ACLMessage(ACLMessage.CFP);
      for (int i = 0; i < sellers; i++) {
        cfp.addReceiver(getAID("plain-" + i));
      }
      cfp.setProtocol(FIPANames.InteractionProtocol.FIPA_CONTRACT_NET);
      cfp.setContent("price");
      return cfp;
    }
  }

  private static final class PlainRound extends ContractNetInitiator {
    private static final long serialVersionUID = 1L;
    private final transient Consumer<ACLMessage> ended;

    PlainRound(Agent agent, ACLMessage cfp, Consumer<ACLMessage> ended) {
      super(agent, cfp);
      this.ended = ended;
    }

    @Override
    @SuppressWarnings({"rawtypes", "unchecked"})
    protected void handleAllResponses(Vector responses, Vector acceptances) {
      ACLMessage best = null;
      for (Object response : responses) {
        ACLMessage proposal = (ACLMessage) response;
        if (best == null || price(proposal) < price(best)) {
          best = proposal;
        }
      }
      for (Object response : responses) {
        ACLMessage decision = ((ACLMessage) response).createReply();
        decision.setPerformative(
            response == best ? ACLMessage.ACCEPT_PROPOSAL : ACLMessage.REJECT_PROPOSAL);
        acceptances.add(decision);
      }
    }

    private static int price(ACLMessage proposal) {
      return Integer.parseInt(proposal.getContent());
    }

    @Override
    protected void handleInform(ACLMessage inform) {
      ended.accept(inform);
    }
  }
}
