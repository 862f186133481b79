package org.maestro.hal;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
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
   */
  void set(Map<String, Term> values, Completion completion);

  /** How it is set now; without what was never set, or counts only while it is on. */
  Map<String, Term> values();

  /** How long it takes to set these. */
  double seconds(Set<String> names);
}
