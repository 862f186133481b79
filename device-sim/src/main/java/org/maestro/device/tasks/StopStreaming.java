package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.rats.member.Execution;

/** Ends streams, which the runtime does by their descriptions; ending none is done too. */
final class StopStreaming extends DeviceProcedure {
  private static final double SECONDS = 0.1;

  @Override
  void start(Execution execution, CallParameters parameters) {
    execution.succeed(Map.of());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
