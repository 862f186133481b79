package org.maestro.device.tasks;

import org.maestro.hal.Face;
import org.maestro.hal.Position;
import org.maestro.rats.member.Execution;

/** Has a face look at something of which it is known where it is. */
final class LookAt extends DeviceProcedure {
  private static final double SECONDS = 0.5;

  private final Face face;

  LookAt(FeatureContext context) {
    this.face = context.driver(Face.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer thing = parameters.pointer("thing");
    face.look(thing.name(), place(thing), ending(execution));
  }

  /**
   * @throws InvalidCallException when nobody who calls knows it
   */
  static Position place(Pointer thing) {
    return thing
        .position()
        .orElseThrow(
            () ->
                new InvalidCallException(
                    "It is not known where %s is; have somebody look for it first."
                        .formatted(thing.name())));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
