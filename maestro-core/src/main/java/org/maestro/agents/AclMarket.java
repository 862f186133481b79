package org.maestro.agents;

import jade.core.AID;
import jade.lang.acl.ACLMessage;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.coordination.Argument;
import org.maestro.coordination.Bid;
import org.maestro.coordination.CallForPrices;
import org.maestro.coordination.Market;
import org.maestro.planning.Step;
import org.maestro.sl.Content;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** The contract net over ACL. */
final class AclMarket implements Market {
  /** Wall time: answering takes what it takes, and the bus itself waits for five seconds. */
  private static final Duration QUOTE_WITHIN = Duration.ofSeconds(7);

  private final MaestroAgent agent;
  private final Function<String, Optional<AID>> agentOf;

  AclMarket(MaestroAgent agent, Function<String, Optional<AID>> agentOf) {
    this.agent = agent;
    this.agentOf = agentOf;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Tender> closed) {
    Map<String, AID> agents = new LinkedHashMap<>();
    for (String member : call.features().keySet()) {
      agentOf.apply(member).ifPresent(aid -> agents.put(member, aid));
    }
    if (agents.isEmpty()) {
      closed.accept(new NobodyThere());
    } else {
      agent.addBehaviour(new ContractNetRound(agent, call, agents, closed));
    }
  }

  @Override
  public void exactPrices(
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    Optional<AID> receiver = agentOf.apply(member);
    if (receiver.isEmpty()) {
      answer.accept(declined(sets.size(), member + " has no agent"));
      return;
    }
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.add(Words.named("feature", Words.name(feature)));
    sets.forEach(set -> arguments.add(Orders.parameters("set", set)));
    ACLMessage question =
        agent.message(ACLMessage.REQUEST, receiver.get(), new Content("cost", arguments));
    agent.ask(
        question, agent.patience(QUOTE_WITHIN), reply -> answered(reply, sets.size(), answer));
  }

  private static void answered(ACLMessage reply, int sets, Consumer<List<Quote>> answer) {
    if (reply.getPerformative() == ACLMessage.AGREE) {
      return;
    }
    List<Quote> quotes = new ArrayList<>();
    try {
      for (Content content : Words.parse(reply.getContent())) {
        quotes.add(quote(Words.of(content)));
      }
    } catch (SlSyntaxException e) {
      quotes.clear();
      quotes.addAll(declined(sets, "answered unreadably: " + e.getMessage()));
    }
    answer.accept(quotes);
  }

  private static Quote quote(Words words) {
    List<Term> numbers = words.find("price").map(Words::terms).orElse(List.of());
    if (numbers.size() == 2
        && numbers.get(0) instanceof Term.Number cost
        && numbers.get(1) instanceof Term.Number seconds) {
      return new Quote.Priced(cost.value(), seconds.value());
    }
    return new Quote.Declined(
        words.string("reason").or(() -> words.string("problem")).orElse("no price given"));
  }

  private static List<Quote> declined(int sets, String reason) {
    return java.util.Collections.nCopies(sets, new Quote.Declined(reason));
  }

  /** The round with nobody to ask. */
  private static final class NobodyThere implements Tender {
    @Override
    public List<Bid> bids() {
      return List.of();
    }

    @Override
    public void award(Map<String, List<Step>> parts) {
      // Nobody bid, nobody is to be told.
    }
  }
}
