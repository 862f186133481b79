package org.maestro.assembly;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.Proposal;
import org.maestro.planning.api.Step;

/** Prices straight from descriptions, and exact ones from the members themselves. */
final class LinkContractNet implements ContractNet {
  private final Deputies deputies;

  LinkContractNet(Deputies deputies) {
    this.deputies = deputies;
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
    return deputies
        .of(member)
        .map(deputy -> deputy.orders().bid(features))
        .orElseGet(() -> new Proposal(member, Map.of(), Optional.of(member + " is not there")));
  }

  @Override
  public void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer) {
    Optional<Deputies.Deputy> deputy = deputies.of(member);
    if (deputy.isPresent()) {
      deputy.get().orders().quote(feature, sets, answer);
      return;
    }
    List<Quote> unanswered = Collections.nCopies(sets.size(), new Quote.Unanswered("is not there"));
    deputies.later(member, () -> answer.accept(unanswered));
  }

  /** Nobody waits for an award: the steps come as calls. */
  private record Open(List<Proposal> bids) implements Round {
    @Override
    public void award(Map<String, List<Step>> parts) {
      // Deputies hold no contract.
    }
  }
}
