package org.maestro.agents.calls;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.ContractNet;
import org.maestro.members.MemberOrders;
import org.maestro.sl.Content;

/**
 * Answers to messages that ask what a feature of a generic agent's member costs: the member is
 * asked. Agent thread only.
 */
public final class PriceQuestions {
  private final MaestroAgent agent;
  private final MemberOrders orders;

  public PriceQuestions(MaestroAgent agent, MemberOrders orders) {
    this.agent = agent;
    this.orders = orders;
  }

  /** Prices for sets of parameters, as a message asks for them. */
  public void cost(ACLMessage message, Words words) {
    List<Map<String, Argument>> sets = new ArrayList<>();
    for (Content.Argument.Named named : words.all()) {
      if (named.name().equals("set")) {
        sets.add(Orders.arguments(Words.of(named)));
      }
    }
    orders.quote(
        words.string("feature").orElse(""),
        sets,
        quotes ->
            agent.reply(
                message,
                ACLMessage.INFORM,
                quotes.stream().map(PriceQuestions::price).toArray(Content[]::new)));
  }

  private static Content price(ContractNet.Quote quote) {
    if (quote instanceof ContractNet.Quote.Priced priced) {
      return Words.content(
          "cost",
          Words.named("price", Words.number(priced.cost()), Words.number(priced.seconds())));
    } else if (quote instanceof ContractNet.Quote.Declined declined) {
      return Words.content("cost", Words.named("reason", Words.text(declined.reason())));
    }
    ContractNet.Quote.Unanswered unanswered = (ContractNet.Quote.Unanswered) quote;
    return Words.content("cost", Words.named("unanswered", Words.text(unanswered.reason())));
  }
}
