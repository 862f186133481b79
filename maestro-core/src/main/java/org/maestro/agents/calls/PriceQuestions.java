package org.maestro.agents.calls;

import jade.lang.acl.ACLMessage;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.agents.content.Orders;
import org.maestro.agents.content.Words;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.ContractNet;
import org.maestro.members.JsonTerms;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.sl.Content;

/**
 * Questions to a generic agent's member over the bus: what it asks for its features. Agent thread
 * only.
 */
public final class PriceQuestions {
  private final MaestroAgent agent;
  private final String member;
  private final RatsLink link;

  public PriceQuestions(MaestroAgent agent, String member, RatsLink link) {
    this.agent = agent;
    this.member = member;
    this.link = link;
  }

  /** Prices for sets of parameters, as a message asks for them. */
  public void cost(ACLMessage message, Words words) {
    List<Map<String, Argument>> sets = new ArrayList<>();
    for (Content.Argument.Named named : words.all()) {
      if (named.name().equals("set")) {
        sets.add(Orders.arguments(Words.of(named)));
      }
    }
    ask(
        words.string("feature").orElse(""),
        sets,
        answers ->
            agent.reply(
                message,
                ACLMessage.INFORM,
                answers.stream().map(PriceQuestions::price).toArray(Content[]::new)));
  }

  /** Exact prices, for the agent's own plans. */
  void quote(
      String feature, List<Map<String, Argument>> sets, Consumer<List<ContractNet.Quote>> answer) {
    ask(
        feature,
        sets,
        answers -> answer.accept(answers.stream().map(PriceQuestions::quote).toList()));
  }

  private void ask(
      String feature, List<Map<String, Argument>> sets, Consumer<List<CostAnswer>> answered) {
    List<Map<String, Object>> parameters = new ArrayList<>();
    for (Map<String, Argument> set : sets) {
      Map<String, Object> json = new TreeMap<>();
      set.forEach((key, argument) -> json.put(key, JsonTerms.json(argument)));
      parameters.add(json);
    }
    link.cost(member, feature, parameters, answers -> agent.tell(() -> answered.accept(answers)));
  }

  private static ContractNet.Quote quote(CostAnswer answer) {
    String reason = answer.reason().orElse("no reason given");
    if (answer.cost().isPresent()) {
      return new ContractNet.Quote.Priced(
          answer.cost().get(), answer.seconds().orElse(answer.cost().get()));
    }
    return answer.answered()
        ? new ContractNet.Quote.Declined(reason)
        : new ContractNet.Quote.Unanswered(reason);
  }

  private static Content price(CostAnswer answer) {
    if (answer.cost().isPresent()) {
      return Words.content(
          "cost",
          Words.named(
              "price",
              Words.number(answer.cost().get()),
              Words.number(answer.seconds().orElse(answer.cost().get()))));
    }
    return Words.content(
        "cost",
        Words.named(
            answer.answered() ? "reason" : "unanswered",
            Words.text(answer.reason().orElse("no reason given"))));
  }
}
