package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.rats.member.Execution;

/** Ends the looks for an object; ending what does not run is done too. */
final class StopObserve extends DeviceProcedure {

  private static final double SECONDS = 0.1;

  private final Observations observations;

  StopObserve(Observations observations) {
    this.observations = observations;
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    observations.end(parameters.pointer("object").name());
    execution.succeed(Map.of());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
