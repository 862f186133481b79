package org.maestro.device.tasks;

import java.util.function.Supplier;

/**
 * What a routine would take now, or why it cannot be done. To find out why can be a far longer
 * search than to find out that: it is made only once somebody asks for the reason.
 */
sealed interface Estimate {

  /**
   * It can be done.
   *
   * @param joules that it uses for it
   */
  record Possible(double seconds, double joules) implements Estimate {}

  /**
   * It cannot.
   *
   * @param reason a sentence without its full stop
   */
  record Impossible(Supplier<String> reason) implements Estimate {}
}
