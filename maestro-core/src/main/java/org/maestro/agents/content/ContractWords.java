package org.maestro.agents.content;

import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.Takeover;

/**
 * The messages that keep the holder of a contract informed while an agent's member is at it: {@code
 * (inform (:member rose) (:feature pick) (:goal G1) (:offer tim) (:cost 4) (:seconds 4))}, or that
 * it comes back by {@code (:release "...")}, or that it is at it still by {@code (:alive true)};
 * and what becomes of what it wanted that others had ({@link ArbitrationWords}).
 */
public final class ContractWords {

  private ContractWords() {}

  public static boolean areIn(Words words) {
    return ArbitrationWords.areIn(words) || areOfAStep(words);
  }

  private static boolean areOfAStep(Words words) {
    return words.string("goal").isPresent()
        && words.string("feature").isPresent()
        && (words.string("offer").isPresent()
            || words.string("release").isPresent()
            || words.string("alive").isPresent());
  }

  public static void tell(Words words, Coordinator coordinator) {
    if (ArbitrationWords.areIn(words)) {
      ArbitrationWords.tell(words, coordinator);
      return;
    }
    String goal = words.string("goal").orElseThrow();
    String member = words.string("member").orElse("");
    String feature = words.string("feature").orElseThrow();
    words.string("release").ifPresent(r -> coordinator.givenBack(goal, member, feature, r));
    words.string("alive").ifPresent(a -> coordinator.alive(goal, member, feature));
    double cost = words.number("cost", -1);
    if (words.string("offer").isPresent() && cost >= 0) {
      double seconds = words.number("seconds", cost);
      coordinator.offered(
          goal, new Takeover(words.string("offer").get(), member, feature, cost, seconds));
    }
  }
}
