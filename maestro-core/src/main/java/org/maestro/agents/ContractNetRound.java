package org.maestro.agents;

import jade.core.AID;
import jade.core.behaviours.SimpleBehaviour;
import jade.domain.FIPANames;
import jade.lang.acl.ACLMessage;
import jade.proto.ContractNetInitiator;
import java.util.ArrayList;
import java.util.Date;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Vector;
import java.util.function.Consumer;
import org.maestro.coordination.Bid;
import org.maestro.coordination.CallForPrices;
import org.maestro.coordination.Market;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.Step;
import org.maestro.sl.Content;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * One FIPA contract-net round of the CCA (M76): a call for proposals to all candidates, early close
 * when all have answered, and accept or reject once the plan is made. The round stays open while
 * others plan; its behaviour blocks without holding the agent.
 */
final class ContractNetRound extends ContractNetInitiator {
  private static final long serialVersionUID = 1L;
  private static final long ANSWER_WITHIN_MILLIS = 10_000;

  /** Wall time has no meaning on a stepped clock; this is only for the case that an agent died. */
  private static final long ANSWER_WITHIN_MILLIS_STEPPED = 60_000;

  private static final long RESULT_WITHIN_MILLIS = 10_000;

  private final transient CallForPrices call;
  private final transient Map<String, AID> agents;
  private final transient Consumer<Market.Tender> closed;
  private final long answerWithinMillis;

  ContractNetRound(
      MaestroAgent agent,
      CallForPrices call,
      Map<String, AID> agents,
      Consumer<Market.Tender> closed) {
    super(agent, null);
    this.call = call;
    this.agents = agents;
    this.closed = closed;
    this.answerWithinMillis =
        agent.clock().isStepped() ? ANSWER_WITHIN_MILLIS_STEPPED : ANSWER_WITHIN_MILLIS;
    registerHandleAllResponses(new Deal());
  }

  @Override
  protected Vector<ACLMessage> prepareCfps(ACLMessage none) {
    Vector<ACLMessage> cfps = new Vector<>();
    agents.forEach(
        (member, agent) -> {
          ACLMessage cfp = new ACLMessage(ACLMessage.CFP);
          cfp.addReceiver(agent);
          cfp.setProtocol(FIPANames.InteractionProtocol.FIPA_CONTRACT_NET);
          cfp.setLanguage(MaestroAgent.LANGUAGE);
          cfp.setOntology(MaestroAgent.ONTOLOGY);
          cfp.setReplyByDate(new Date(System.currentTimeMillis() + answerWithinMillis));
          cfp.setContent(Words.print(question(member)));
          cfps.add(cfp);
        });
    return cfps;
  }

  private Content question(String member) {
    return Words.content(
        "cost",
        Words.named("goal", Words.name(call.goalId()), Words.formula(call.goal())),
        Words.named("features", call.features().get(member).stream().map(Words::name).toList()));
  }

  private List<Bid> bids(List<ACLMessage> answers) {
    Map<String, Bid> bids = new LinkedHashMap<>();
    agents.forEach(
        (member, agent) ->
            bids.put(member, new Bid(member, Map.of(), Optional.of("did not answer in time"))));
    for (ACLMessage answer : answers) {
      agents.forEach(
          (member, agent) -> {
            if (agent.equals(answer.getSender())) {
              bids.put(member, bid(member, answer));
            }
          });
    }
    return List.copyOf(bids.values());
  }

  private static Bid bid(String member, ACLMessage answer) {
    try {
      List<Content> contents = Words.parse(answer.getContent());
      if (answer.getPerformative() != ACLMessage.PROPOSE) {
        String reason =
            contents.stream()
                .findFirst()
                .flatMap(c -> Words.of(c).string("reason"))
                .orElse(ACLMessage.getPerformative(answer.getPerformative()).toLowerCase());
        return new Bid(member, Map.of(), Optional.of(reason));
      }
      Map<String, Price> prices = new LinkedHashMap<>();
      for (Content content : contents) {
        Words words = Words.of(content);
        String feature = words.string("feature").orElse("");
        words
            .string("stated")
            .ifPresent(text -> prices.put(feature, new Price.Stated(SlParser.expression(text))));
        words
            .string("at-least")
            .ifPresent(text -> prices.put(feature, new Price.Asked(SlParser.expression(text))));
      }
      return new Bid(member, prices, Optional.empty());
    } catch (SlSyntaxException e) {
      return new Bid(member, Map.of(), Optional.of("answered unreadably: " + e.getMessage()));
    }
  }

  /** Waits for the award between the last response and the acceptances. */
  private final class Deal extends SimpleBehaviour implements Market.Tender {
    private static final long serialVersionUID = 1L;
    private boolean announced;
    private boolean awarded;
    private transient List<ACLMessage> answers = List.of();

    @Override
    public void action() {
      if (!announced) {
        announced = true;
        answers = messages(ALL_RESPONSES_KEY);
        closed.accept(this);
      }
      if (!awarded) {
        block();
      }
    }

    @Override
    public boolean done() {
      return awarded;
    }

    @Override
    public List<Bid> bids() {
      return ContractNetRound.this.bids(answers);
    }

    @Override
    public void award(Map<String, List<Step>> parts) {
      List<ACLMessage> decisions = new ArrayList<>();
      for (ACLMessage answer : answers) {
        if (answer.getPerformative() == ACLMessage.PROPOSE) {
          decisions.add(decision(answer, parts));
        }
      }
      acceptances().addAll(decisions);
      awarded = true;
      restart();
    }

    private ACLMessage decision(ACLMessage answer, Map<String, List<Step>> parts) {
      List<Step> part =
          agents.entrySet().stream()
              .filter(e -> e.getValue().equals(answer.getSender()))
              .map(e -> parts.getOrDefault(e.getKey(), List.of()))
              .findFirst()
              .orElse(List.of());
      ACLMessage decision = answer.createReply();
      if (part.isEmpty()) {
        decision.setPerformative(ACLMessage.REJECT_PROPOSAL);
        decision.setContent(
            Words.print(Words.content("inform", Words.named("goal", Words.name(call.goalId())))));
      } else {
        decision.setPerformative(ACLMessage.ACCEPT_PROPOSAL);
        decision.setReplyByDate(new Date(System.currentTimeMillis() + RESULT_WITHIN_MILLIS));
        decision.setContent(
            Words.print(part.stream().map(step -> Orders.step(call.goalId(), step)).toList()));
      }
      return decision;
    }

    private List<ACLMessage> messages(String key) {
      List<ACLMessage> messages = new ArrayList<>();
      for (Object message : (Vector<?>) getDataStore().get(key)) {
        messages.add((ACLMessage) message);
      }
      return messages;
    }

    @SuppressWarnings("unchecked")
    private List<ACLMessage> acceptances() {
      return (List<ACLMessage>) getDataStore().get(ALL_ACCEPTANCES_KEY);
    }
  }
}
