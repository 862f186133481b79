package org.maestro.rats.member;

import java.util.Map;
import org.maestro.rats.protocol.CostAnswer;

/**
 * The routine behind a feature (phi). All methods are called on the clock's thread and must not
 * block: a routine that takes time schedules its own continuation and reports through the {@link
 * Execution}.
 */
public interface Procedure {

  void start(Execution execution);

  /** What it would cost with these parameters, from where the member is now (M54). */
  CostAnswer cost(Map<String, Object> parameters);
}
