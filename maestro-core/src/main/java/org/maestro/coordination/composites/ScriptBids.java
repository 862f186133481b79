package org.maestro.coordination.composites;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Step;

/** A contract net in which scripts bid as well, at the prices that are stated. */
final class ScriptBids implements ContractNet {
  private final ContractNet agents;
  private final KnowledgeBase knowledge;

  ScriptBids(ContractNet agents, KnowledgeBase knowledge) {
    this.agents = agents;
    this.knowledge = knowledge;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    Map<String, List<String>> others = new LinkedHashMap<>(call.features());
    List<String> scripts = others.remove(Script.PLANNED_AS);
    if (scripts == null) {
      agents.callForPrices(call, closed);
      return;
    }
    agents.callForPrices(
        new CallForPrices(call.goalId(), call.goal(), others),
        round -> closed.accept(new Beside(round, bid(scripts))));
  }

  private Proposal bid(List<String> scripts) {
    Map<String, Price> prices = new LinkedHashMap<>();
    for (String name : scripts) {
      Optional.ofNullable(knowledge.home().scripts().get(name))
          .flatMap(Script::action)
          .map(FeatureType::cost)
          .ifPresent(price -> prices.put(name, price));
    }
    return new Proposal(Script.PLANNED_AS, prices, Optional.empty());
  }

  @Override
  public void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    agents.exactPrices(goalId, member, feature, sets, answer);
  }

  /** A round of agents, and the bid of the scripts. */
  private record Beside(Round round, Proposal bid) implements Round {
    @Override
    public List<Proposal> bids() {
      return Stream.concat(round.bids().stream(), Stream.of(bid)).toList();
    }

    @Override
    public void award(Map<String, List<Step>> parts) {
      Map<String, List<Step>> others = new LinkedHashMap<>();
      parts.forEach((member, steps) -> others.put(member, new ArrayList<>(steps)));
      others.remove(Script.PLANNED_AS);
      round.award(others);
    }
  }
}
