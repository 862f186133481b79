package org.maestro.platform;

import java.util.function.Consumer;
import java.util.function.Function;
import org.maestro.agents.CoordinatorAgent;
import org.maestro.agents.goals.Past;
import org.maestro.platform.journal.Chronicle;
import org.maestro.rats.time.Clock;

/**
 * The central agent, which can be ended and started again; its goals go on. Any thread may call.
 */
final class CentralAgent {
  private final Function<Past, CoordinatorAgent> making;
  private final Chronicle chronicle;
  private volatile CoordinatorAgent coordinator;
  private volatile boolean isThere = true;

  /**
   * @param making makes one, with the past on which it goes on
   */
  CentralAgent(Past past, Clock clock, Function<Past, CoordinatorAgent> making) {
    this.making = making;
    this.chronicle = new Chronicle(past.journal(), clock, past.recovery());
    this.coordinator = making.apply(new Past(chronicle, past.recovery(), past.stories()));
  }

  /** The one there is now, or the last one. */
  CoordinatorAgent now() {
    return coordinator;
  }

  /** It has ended. */
  void ended() {
    isThere = false;
  }

  /**
   * Makes another in the place of one that was ended.
   *
   * @param starting has it begin
   * @return false when it is there
   */
  synchronized boolean revive(Consumer<CoordinatorAgent> starting) {
    if (isThere) {
      return false;
    }
    CoordinatorAgent revived =
        making.apply(new Past(chronicle, chronicle.recovery(), coordinator.stories(), true));
    coordinator = revived;
    isThere = true;
    starting.accept(revived);
    return true;
  }
}
