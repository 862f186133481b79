package org.maestro.rats.time;

import java.time.Duration;
import java.util.List;

/**
 * A stepped clock waited too long (wall time) for tickets to be closed: some activity hangs, or
 * forgot its ticket.
 */
public final class ClockStalledException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  ClockStalledException(Duration simulated, Duration limit, List<String> holders) {
    super(
        "The stepped clock stands at "
            + simulated
            + " since "
            + limit.toSeconds()
            + " s of wall time because these still hold a ticket: "
            + String.join(", ", holders)
            + "; each must close it when its work is done");
  }
}
