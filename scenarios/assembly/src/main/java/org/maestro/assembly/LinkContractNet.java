package org.maestro.assembly;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.members.JsonTerms;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Step;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.CostAnswer;

/** Prices straight from descriptions, and exact ones from the members themselves. */
final class LinkContractNet implements ContractNet {
  private final Deputies deputies;
  private final RatsLink link;

  LinkContractNet(Deputies deputies, RatsLink link) {
    this.deputies = deputies;
    this.link = link;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    deputies.later(
        call.goalId(),
        () -> {
          List<Proposal> bids = new ArrayList<>();
          call.features().forEach((member, features) -> bids.add(bid(member, features)));
          closed.accept(new Open(bids));
        });
  }

  private Proposal bid(String member, List<String> features) {
    Optional<Deputies.Deputy> deputy = deputies.of(member);
    if (deputy.isEmpty()) {
      return new Proposal(member, Map.of(), Optional.of(member + " is not there"));
    }
    Map<String, Price> prices = new LinkedHashMap<>();
    for (String name : features) {
      deputy.get().view().feature(name).ifPresent(f -> prices.put(name, f.cost()));
    }
    return new Proposal(
        member,
        prices,
        prices.isEmpty() ? Optional.of(member + " has none of these features") : Optional.empty());
  }

  @Override
  public void exactPrices(
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    if (deputies.of(member).isEmpty()) {
      List<Quote> unanswered =
          Collections.nCopies(sets.size(), new Quote.Unanswered("is not there"));
      deputies.later(member, () -> answer.accept(unanswered));
      return;
    }
    link.cost(
        member,
        feature,
        sets.stream().map(LinkContractNet::json).toList(),
        answers ->
            deputies.later(
                member,
                () -> answer.accept(answers.stream().map(LinkContractNet::quote).toList())));
  }

  static Map<String, Object> json(Map<String, Argument> arguments) {
    Map<String, Object> values = new TreeMap<>();
    arguments.forEach((name, argument) -> values.put(name, JsonTerms.json(argument)));
    return values;
  }

  private static Quote quote(CostAnswer answer) {
    return answer
        .cost()
        .<Quote>map(cost -> new Quote.Priced(cost, answer.seconds().orElse(cost)))
        .orElseGet(() -> unpriced(answer.answered(), answer.reason().orElse("no reason given")));
  }

  private static Quote unpriced(boolean answered, String reason) {
    return answered ? new Quote.Declined(reason) : new Quote.Unanswered(reason);
  }

  /** Nobody waits for an award: the steps come as calls. */
  private record Open(List<Proposal> bids) implements Round {
    @Override
    public void award(Map<String, List<Step>> parts) {
      // Deputies hold no contract.
    }
  }
}
