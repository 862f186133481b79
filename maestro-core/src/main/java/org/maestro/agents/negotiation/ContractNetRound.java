package org.maestro.agents.negotiation;

import jade.core.AID;
import jade.core.behaviours.SimpleBehaviour;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.proto.ContractNetInitiator;
import jade.proto.states.MsgReceiver;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Vector;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.ProposalReader;
import org.maestro.agents.content.Replies;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.agents.runtime.ProtocolTimeouts;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Content;

/**
 * One FIPA contract-net round of a coordinator (Three-layered architecture, 3.3.3; M76): a call for
 * proposals to all candidates, early close when all have answered, accept or reject once the plan
 * is made, and the word of each winner that it holds its part. The round stays open while others
 * plan; its behaviour blocks without holding the agent.
 *
 * <p>The clock alone ends its waits: JADE's own deadlines are wall time, which means nothing on a
 * stepped clock. The round ends within the patience for bids, offers and contracts, whatever the
 * others do.
 */
final class ContractNetRound extends ContractNetInitiator {
  private static final long serialVersionUID = 1L;

  private final transient MaestroAgent agent;
  private final transient CallForPrices call;
  private final transient Map<String, AID> agents;
  private final transient Contracts contracts;
  private final transient ProtocolViolations misconduct;
  private final transient Consumer<ContractNet.Round> closed;
  private final transient Map<String, ACLMessage> answers = new LinkedHashMap<>();
  private final transient Map<String, String> memberByKey = new HashMap<>();
  private final transient Map<String, Contracts.Contract> awarded = new LinkedHashMap<>();
  private final transient List<String> receivers = new ArrayList<>();
  private transient Clock.Timer timer = () -> {};
  private boolean awarding;
  private volatile @Nullable String conversation;
  private int waits;

  ContractNetRound(
      MaestroAgent agent,
      CallForPrices call,
      Map<String, AID> agents,
      Contracts contracts,
      ProtocolViolations misconduct,
      Consumer<ContractNet.Round> closed) {
    super(agent, null);
    this.agent = agent;
    this.call = call;
    this.agents = agents;
    this.contracts = contracts;
    this.misconduct = misconduct;
    this.closed = closed;
    registerHandleAllResponses(new Deal());
  }

  /** Whether there is an answer to be read, or it is not known yet what answers look like. */
  boolean hasMail() {
    String own = conversation;
    return own == null || agent.hasMailOf(own);
  }

  @Override
  protected Vector<ACLMessage> prepareCfps(ACLMessage none) {
    Vector<ACLMessage> cfps = new Vector<>();
    agents.forEach(
        (member, receiver) -> {
          ACLMessage cfp = agent.message(ACLMessage.CFP, receiver, question(member, receiver));
          cfp.setProtocol(FIPANames.InteractionProtocol.FIPA_CONTRACT_NET);
          cfp.setReplyByDate(agent.replyBy(patience().bid()));
          cfps.add(cfp);
          receivers.add(member);
        });
    return cfps;
  }

  private Content question(String member, AID receiver) {
    List<Content.Argument> arguments =
        new ArrayList<>(Orders.member(member, receiver.getLocalName()));
    arguments.add(Words.named("goal", Words.name(call.goalId()), Words.formula(call.goal())));
    arguments.add(
        Words.named("features", featuresWanted(member).stream().map(Words::name).toList()));
    return new Content("cost", arguments);
  }

  private List<String> featuresWanted(String member) {
    return Objects.requireNonNull(call.features().get(member));
  }

  /** Sends the calls, and later the decisions; then waits for the clock instead of JADE's. */
  @Override
  protected void sendInitiations(@SuppressWarnings("rawtypes") Vector initiations) {
    super.sendInitiations(initiations);
    replyReceiver.setDeadline(MsgReceiver.INFINITE);
    memberByKey.clear();
    Vector<?> sent = (Vector<?>) getDataStore().get(ALL_CFPS_KEY);
    for (int i = 0; i < sent.size(); i++) {
      ACLMessage message = (ACLMessage) sent.get(i);
      conversation = message.getConversationId();
      if (message.getReplyWith() != null) {
        memberByKey.put(message.getReplyWith(), receivers.get(i));
      }
    }
    agent.conversations().adopt(Objects.requireNonNull(conversation), this::partnerEnded);
    if (sessions.size() > 0) {
      endWaitAfter(awarding ? patience().contract() : patience().bid());
    }
  }

  /**
   * What was sent to an agent that ends before it answers ends with it, and the platform says no
   * word of that.
   */
  private void partnerEnded(String localName) {
    memberByKey.forEach(
        (key, member) -> {
          AID asked = Objects.requireNonNull(agents.get(member));
          if (sessions.containsKey(key) && asked.getLocalName().equals(localName)) {
            ACLMessage failure = new ACLMessage(ACLMessage.FAILURE);
            failure.setSender(agent.getAMS());
            failure.setConversationId(conversation);
            failure.setInReplyTo(key);
            agent.postMessage(failure);
          }
        });
  }

  private ProtocolTimeouts patience() {
    return agent.patience();
  }

  private void endWaitAfter(Duration wait) {
    int number = ++waits;
    timer =
        agent
            .clock()
            .schedule(
                agent.patience(wait),
                agent.getLocalName(),
                () -> agent.tell(() -> endWait(number)));
  }

  private void endWait(int number) {
    if (number == waits) {
      replyReceiver.interrupt();
    }
  }

  /** Sorts replies: from whom they are, what they answer, and whether they may. */
  @Override
  protected boolean checkInSequence(ACLMessage reply) {
    String key = reply.getInReplyTo();
    Optional<String> member =
        Optional.ofNullable(memberByKey.get(key)).filter(m -> isFrom(m, reply));
    if (member.isEmpty()) {
      stray(reply);
      return false;
    }
    boolean first = sessions.containsKey(key);
    boolean inSequence = super.checkInSequence(reply);
    if (first) {
      sessions.remove(key);
      answered(member.get(), reply, inSequence);
    } else {
      stray(reply);
    }
    return inSequence;
  }

  private boolean isFrom(String member, ACLMessage reply) {
    AID asked = Objects.requireNonNull(agents.get(member));
    return asked.equals(reply.getSender()) || Replies.isFromPlatform(reply);
  }

  private void answered(String member, ACLMessage reply, boolean inSequence) {
    if (awarding) {
      settle(member, reply, inSequence);
    } else {
      answers.put(member, reply);
    }
  }

  private void settle(String member, ACLMessage reply, boolean inSequence) {
    if (inSequence && reply.getPerformative() == ACLMessage.INFORM) {
      contractWith(member).held();
      return;
    }
    String why = Replies.reason(reply).map(Replies::shortened).map(r -> ": " + r).orElse("");
    broken(
        member,
        Replies.isFromPlatform(reply)
            ? " has no agent any more to hold its part"
            : reply.getPerformative() == ACLMessage.FAILURE
                ? " does not hold its part" + why
                : " answered the award with " + ProposalReader.performative(reply) + why);
  }

  private void broken(String member, String how) {
    misconduct.noted(call.goalId(), member + how);
    contractWith(member).broken(member + how);
  }

  private Contracts.Contract contractWith(String winner) {
    return Objects.requireNonNull(awarded.get(winner));
  }

  /** A reply that nothing was waiting for. */
  private void stray(ACLMessage reply) {
    if (Replies.isFromPlatform(reply)) {
      return;
    }
    String what = ProposalReader.performative(reply);
    Optional<String> member =
        agents.entrySet().stream()
            .filter(e -> e.getValue().equals(reply.getSender()))
            .map(Map.Entry::getKey)
            .findFirst();
    String sentence;
    if (member.isEmpty()) {
      sentence =
          Replies.sender(reply) + " answered (" + what + ") though it was not asked; ignored";
    } else if (!answers.containsKey(member.get())) {
      sentence = member.get() + " answered (" + what + ") after the round was closed; ignored";
    } else if (!awarding && reply.getPerformative() == ACLMessage.INFORM) {
      sentence = member.get() + " informed before its proposal was accepted; ignored";
    } else {
      sentence = member.get() + " answered once more (" + what + "); its first answer counts";
    }
    misconduct.noted(call.goalId(), sentence);
  }

  /** An answer that is against the protocol is an answer all the same: nobody waits for another. */
  @Override
  protected void handleOutOfSequence(ACLMessage reply) {
    if (sessions.size() == 0) {
      replyReceiver.interrupt();
    }
  }

  @Override
  protected int checkSessions(ACLMessage reply) {
    int next = super.checkSessions(reply);
    if (next != -1) {
      timer.cancel();
      waits++;
    }
    return next;
  }

  @Override
  public int onEnd() {
    timer.cancel();
    String own = conversation;
    if (own != null) {
      agent.conversations().leave(own);
    }
    awarded.forEach(
        (member, contract) -> {
          if (!contract.isSettled()) {
            broken(
                member,
                " did not say within "
                    + Replies.seconds(patience().contract())
                    + " that it holds its part");
          }
        });
    return super.onEnd();
  }

  private List<Proposal> readBids() {
    List<Proposal> bids = new ArrayList<>();
    agents
        .keySet()
        .forEach(
            member -> {
              ACLMessage answer = answers.get(member);
              if (answer == null) {
                String silence =
                    "did not answer the call for prices within "
                        + Replies.seconds(patience().bid());
                misconduct.noted(call.goalId(), member + " " + silence);
                bids.add(new Proposal(member, Map.of(), Optional.of(silence)));
              } else {
                ProposalReader reader = new ProposalReader(member, featuresWanted(member));
                bids.add(reader.read(answer));
                reader.faults().forEach(fault -> misconduct.noted(call.goalId(), fault));
              }
            });
    return List.copyOf(bids);
  }

  /** Waits for the award between the last response and the acceptances. */
  private final class Deal extends SimpleBehaviour implements ContractNet.Round {
    private static final long serialVersionUID = 1L;
    private boolean announced;
    private transient List<Proposal> bids = List.of();

    @Override
    public void action() {
      if (!announced) {
        announced = true;
        bids = readBids();
        int number = ++waits;
        timer =
            agent
                .clock()
                .schedule(
                    agent.patience(patience().offer()),
                    agent.getLocalName(),
                    () -> agent.tell(() -> giveUp(number)));
        agent.work(() -> closed.accept(this));
      }
      for (ACLMessage late = late(); late != null; late = late()) {
        stray(late);
      }
      if (!awarding) {
        block();
      }
    }

    private @Nullable ACLMessage late() {
      return awarding ? null : agent.receive(replyTemplate);
    }

    private void giveUp(int number) {
      if (number == waits) {
        reject();
      }
    }

    @Override
    public boolean done() {
      return awarding;
    }

    @Override
    public List<Proposal> bids() {
      return bids;
    }

    /** Once the offers have run out, a plan finds no contract any more. */
    @Override
    public void award(Map<String, List<Step>> parts) {
      if (awarding) {
        return;
      }
      timer.cancel();
      waits++;
      receivers.clear();
      answers.forEach(
          (member, answer) -> {
            if (answer.getPerformative() == ACLMessage.PROPOSE) {
              acceptances().add(decision(member, answer, parts.getOrDefault(member, List.of())));
              receivers.add(member);
            }
          });
      awarding = true;
      restart();
    }

    private ACLMessage decision(String member, ACLMessage answer, List<Step> part) {
      ACLMessage decision = answer.createReply();
      decision.setLanguage(Words.LANGUAGE);
      decision.setOntology(Words.ONTOLOGY);
      if (part.isEmpty()) {
        decision.setPerformative(ACLMessage.REJECT_PROPOSAL);
        decision.setContent(
            Words.print(Words.content("inform", Words.named("goal", Words.name(call.goalId())))));
      } else {
        decision.setPerformative(ACLMessage.ACCEPT_PROPOSAL);
        decision.setReplyByDate(agent.replyBy(patience().contract()));
        decision.setContent(
            Words.print(part.stream().map(step -> Orders.step(call.goalId(), step)).toList()));
        awarded.put(member, contracts.award(call.goalId(), member));
      }
      return decision;
    }

    @SuppressWarnings("unchecked")
    private List<ACLMessage> acceptances() {
      return (List<ACLMessage>) getDataStore().get(ALL_ACCEPTANCES_KEY);
    }
  }
}
