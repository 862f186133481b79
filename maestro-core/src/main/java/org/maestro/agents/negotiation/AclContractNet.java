package org.maestro.agents.negotiation;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.BatchingBehaviour;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.WithOthers;
import org.maestro.planning.api.Step;
import org.maestro.sl.Content;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/** The contract net over ACL. */
public final class AclContractNet implements ContractNet {
  private static final Logger LOG = LoggerFactory.getLogger(AclContractNet.class);

  private final MaestroAgent agent;
  private final Function<String, Optional<AID>> agentOf;
  private final Contracts contracts;
  private final ProtocolViolations misconduct;

  public AclContractNet(
      MaestroAgent agent,
      Function<String, Optional<AID>> agentOf,
      Contracts contracts,
      ProtocolViolations misconduct) {
    this.agent = agent;
    this.agentOf = agentOf;
    this.contracts = contracts;
    this.misconduct = misconduct;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    Map<String, AID> asked = new LinkedHashMap<>();
    List<Proposal> distrusted = new ArrayList<>();
    for (String member : call.features().keySet()) {
      Optional<String> distrust = contracts.distrust(call.goalId(), member);
      if (distrust.isPresent()) {
        distrusted.add(new Proposal(member, Map.of(), distrust));
      } else {
        agentOf.apply(member).ifPresent(aid -> asked.put(member, aid));
      }
    }
    Consumer<Round> complete =
        tender -> closed.accept(distrusted.isEmpty() ? tender : new WithOthers(tender, distrusted));
    if (asked.isEmpty()) {
      complete.accept(new NobodyThere());
    } else {
      ContractNetRound round =
          new ContractNetRound(agent, call, asked, contracts, misconduct, complete);
      agent.addBehaviour(new BatchingBehaviour(round, round::hasMail));
    }
  }

  @Override
  public void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    Optional<AID> receiver = agentOf.apply(member);
    if (receiver.isEmpty()) {
      answer.accept(QuoteReader.unanswered(sets.size(), "has no agent"));
      return;
    }
    List<Content.Argument> arguments =
        new ArrayList<>(Orders.member(member, receiver.get().getLocalName()));
    arguments.add(Words.named("goal", Words.name(goalId)));
    arguments.add(Words.named("feature", Words.name(feature)));
    sets.forEach(set -> arguments.add(Orders.parameters("set", set)));
    ACLMessage question =
        agent.message(ACLMessage.REQUEST, receiver.get(), new Content("cost", arguments));
    QuoteReader reader = new QuoteReader(member, feature, sets.size());
    agent
        .conversations()
        .ask(
            question,
            agent.patience(agent.patience().quote()),
            reply -> {
              if (reply.getPerformative() != ACLMessage.AGREE) {
                List<Quote> quotes = reader.read(reply, agent.patience().quote());
                reader.faults().forEach(fault -> LOG.warn("{}", fault));
                answer.accept(quotes);
              }
            });
  }

  /** The round with nobody to ask. */
  private static final class NobodyThere implements Round {
    @Override
    public List<Proposal> bids() {
      return List.of();
    }

    @Override
    public void award(Map<String, List<Step>> parts) {
      // Nobody bid, nobody is to be told.
    }
  }
}
