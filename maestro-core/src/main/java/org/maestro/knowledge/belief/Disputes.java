package org.maestro.knowledge.belief;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.Dispute;
import org.maestro.knowledge.api.StateVariable;

/** Finds what sources disagree on in one cell. */
record Disputes(StateVariable variable, Cell cell, Predicate<Held> counts) {

  Optional<Dispute> dispute() {
    Settled settled = cell.settled(counts);
    List<Claim> losers = new ArrayList<>(settled.losers());
    cell.overruled().stream().filter(claim -> counts.test(claim.held())).forEach(losers::add);
    if (losers.isEmpty()) {
      return Optional.empty();
    }
    losers.sort(Comparator.comparingLong((Claim claim) -> claim.held().serial()).reversed());
    Optional<Claim> best = best(settled);
    return Optional.of(
        new Dispute(
            best.map(this::belief),
            losers.stream()
                .map(loser -> new Dispute.Loser(belief(loser), rule(best, loser)))
                .toList()));
  }

  private static Optional<Claim> best(Settled settled) {
    return settled
        .value()
        .map(held -> new Claim(held, true))
        .or(() -> settled.excluded().values().stream().findFirst().map(h -> new Claim(h, false)));
  }

  private static Dispute.Rule rule(Optional<Claim> best, Claim loser) {
    if (loser.held().isExpected() && best.filter(claim -> !claim.held().isExpected()).isPresent()) {
      return Dispute.Rule.SEEN;
    }
    return best.filter(claim -> claim.weight() > loser.weight()).isPresent()
        ? Dispute.Rule.SURER
        : Dispute.Rule.LATER;
  }

  private Belief belief(Claim claim) {
    Held held = claim.held();
    return new Belief(
        Wording.value(variable, held, claim.has()), held.source(), held.since(), held.confidence());
  }
}
