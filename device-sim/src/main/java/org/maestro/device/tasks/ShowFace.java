package org.maestro.device.tasks;

import org.maestro.hal.Face;
import org.maestro.rats.member.Execution;

/** Has a face be that of another persona. */
final class ShowFace extends DeviceProcedure {
  private static final double SECONDS = 0.1;

  private final Face face;

  ShowFace(FeatureContext context) {
    this.face = context.driver(Face.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    face.appear(parameters.text("persona"), ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
