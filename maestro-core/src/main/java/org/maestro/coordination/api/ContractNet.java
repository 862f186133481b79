package org.maestro.coordination.api;

import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.planning.api.Step;

/**
 * The contract net, as coordination sees it. Answers come on the coordinator's thread, exactly once
 * each.
 */
public interface ContractNet {

  void callForPrices(CallForPrices call, Consumer<Round> closed);

  /**
   * Asks one member what parameter sets would cost exactly; as many answers as sets, in order.
   *
   * @param goalId for which it is asked
   */
  void exactPrices(
      String goalId,
      String member,
      String feature,
      List<Map<String, Argument>> sets,
      Consumer<List<Quote>> answer);

  /** A round whose bids are in. */
  interface Round {
    List<Proposal> bids();

    /**
     * Closes the round: each member named gets its part, the others are rejected. To be called
     * exactly once.
     */
    void award(Map<String, List<Step>> parts);

    /** Closes the round: all are rejected. In place of an award. */
    default void reject() {
      award(Map.of());
    }
  }

  /** An exact price, or why there is none. */
  sealed interface Quote {
    record Priced(double cost, double seconds) implements Quote {}

    /** The member says that it cannot do it. */
    record Declined(String reason) implements Quote {}

    /** Nothing usable came; the member may well be able to do it. */
    record Unanswered(String reason) implements Quote {}
  }
}
