package org.maestro.agents.negotiation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.Bid;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.Market;

/** A market on which nobody is asked for what the goal's requester may not ask for. */
public final class PermittedMarket implements Market {
  private final Market market;
  private final Clients clients;

  public PermittedMarket(Market market, Clients clients) {
    this.market = market;
    this.clients = clients;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Tender> closed) {
    Map<String, List<String>> permitted = new TreeMap<>();
    List<Bid> refusals = new ArrayList<>();
    call.features()
        .forEach(
            (member, features) -> {
              List<Clients.Refused> refused = clients.refused(call.goalId(), member, features);
              List<String> left = new ArrayList<>(features);
              refused.forEach(one -> left.remove(one.feature()));
              if (!left.isEmpty()) {
                permitted.put(member, List.copyOf(left));
              } else if (!refused.isEmpty()) {
                refusals.add(new Bid(member, Map.of(), Optional.of(refused.get(0).reason())));
              }
            });
    if (permitted.equals(call.features())) {
      market.callForPrices(call, closed);
    } else {
      market.callForPrices(
          new CallForPrices(call.goalId(), call.goal(), permitted),
          tender -> closed.accept(new WithOthers(tender, refusals)));
    }
  }

  @Override
  public void exactPrices(
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    market.exactPrices(member, feature, sets, answer);
  }
}
