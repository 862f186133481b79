package org.maestro.rats.member;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.rats.protocol.CostAnswer;

/**
 * The routine behind a feature (phi). All methods are called on the clock's thread and must not
 * block: a routine that takes time schedules its own continuation and reports through the {@link
 * Execution}.
 */
public interface Procedure {

  void start(Execution execution);

  /**
   * What it would cost with these parameters, from where the member is now (Three-layered
   * architecture, 3.2.2; M54).
   */
  CostAnswer cost(Map<String, Object> parameters);

  /**
   * The same for a routine that has to find out first, from its hardware or by a long search: it
   * answers on the clock's thread, once, and within 50 ms of wall time. For one that does not, the
   * runtime says to the caller why there is no price; what comes later is not heard.
   */
  default void cost(Map<String, Object> parameters, Consumer<CostAnswer> answer) {
    answer.accept(cost(parameters));
  }

  /**
   * The same for who does not ask why not: empty where it cannot be done. A routine that would have
   * to search for the reason leaves that search out.
   */
  default Optional<CostAnswer> costIfAble(Map<String, Object> parameters) {
    return Optional.of(cost(parameters)).filter(answer -> answer.cost().isPresent());
  }

  /**
   * Whether it could begin as the member is now, whatever the parameters (Three-layered
   * architecture, 3.2.1; M33). While it could not, the member tells the feature as disabled. A call
   * that comes meanwhile still has its turn, since one before it in the queue may change that; when
   * nothing has, the routine fails it with what is missing.
   */
  default boolean isPossibleNow() {
    return true;
  }
}
