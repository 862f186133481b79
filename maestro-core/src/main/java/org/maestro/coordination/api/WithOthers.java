package org.maestro.coordination.api;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.maestro.planning.api.Step;

/** A round with the bids of those who were not asked. */
public record WithOthers(ContractNet.Round round, List<Proposal> others)
    implements ContractNet.Round {
  public WithOthers {
    others = List.copyOf(others);
  }

  @Override
  public List<Proposal> bids() {
    List<Proposal> all = new ArrayList<>(round.bids());
    all.addAll(others);
    return List.copyOf(all);
  }

  @Override
  public void award(Map<String, List<Step>> parts) {
    round.award(parts);
  }
}
