package org.maestro.hal;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BooleanSupplier;
import org.maestro.sl.Term;

/**
 * What can be set at an appliance, by the names that its description has: a volume, a source, the
 * show on a television.
 */
public interface Settings {

  /** All that can be set. */
  Set<String> names();

  /** Why it cannot be set so; one sentence. Empty when it can. */
  Optional<String> refusal(Map<String, Term> values);

  /**
   * @param values those that are to become otherwise; allowed ones
   * @param isCalledOff whether nobody wants it any more: what takes time is given up then, and
   *     stays as it was
   */
  void set(Map<String, Term> values, Completion completion, BooleanSupplier isCalledOff);

  /** How it is set now; without what was never set, or counts only while it is on. */
  Map<String, Term> values();

  /** How long it takes to set these. */
  double seconds(Set<String> names);
}
