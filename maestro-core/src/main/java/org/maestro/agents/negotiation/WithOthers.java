package org.maestro.agents.negotiation;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.maestro.coordination.api.Bid;
import org.maestro.coordination.api.Market;
import org.maestro.planning.api.Step;

/** A round with the bids of those who were not asked. */
record WithOthers(Market.Tender round, List<Bid> others) implements Market.Tender {
  WithOthers {
    others = List.copyOf(others);
  }

  @Override
  public List<Bid> bids() {
    List<Bid> all = new ArrayList<>(round.bids());
    all.addAll(others);
    return List.copyOf(all);
  }

  @Override
  public void award(Map<String, List<Step>> parts) {
    round.award(parts);
  }
}
