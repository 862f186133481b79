package org.maestro.agents.negotiation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.WithOthers;

/** A market on which nobody is asked for what the goal's requester may not ask for. */
public final class PermittedContractNet implements ContractNet {
  private final ContractNet contractNet;
  private final Clients clients;

  public PermittedContractNet(ContractNet contractNet, Clients clients) {
    this.contractNet = contractNet;
    this.clients = clients;
  }

  @Override
  public void callForPrices(CallForPrices call, Consumer<Round> closed) {
    Map<String, List<String>> permitted = new TreeMap<>();
    List<Proposal> refusals = new ArrayList<>();
    call.features()
        .forEach(
            (member, features) -> {
              List<Clients.Refused> refused = clients.refused(call.goalId(), member, features);
              List<String> left = new ArrayList<>(features);
              refused.forEach(one -> left.remove(one.feature()));
              if (!left.isEmpty()) {
                permitted.put(member, List.copyOf(left));
              } else if (!refused.isEmpty()) {
                refusals.add(new Proposal(member, Map.of(), Optional.of(refused.get(0).reason())));
              }
            });
    if (permitted.equals(call.features())) {
      contractNet.callForPrices(call, closed);
    } else {
      contractNet.callForPrices(
          new CallForPrices(call.goalId(), call.goal(), permitted),
          tender -> closed.accept(new WithOthers(tender, refusals)));
    }
  }

  @Override
  public void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    contractNet.exactPrices(goalId, member, feature, sets, answer);
  }
}
