package org.maestro.device.tasks;

import org.maestro.hal.Face;
import org.maestro.hal.Position;
import org.maestro.rats.member.Execution;

/** Has a face look and point at something of which it is known where it is. */
final class PointAt extends DeviceProcedure {
  private static final double SECONDS = 2;

  private final Face face;

  PointAt(FeatureContext context) {
    this.face = context.driver(Face.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    Pointer thing = parameters.pointer("thing");
    Position at = LookAt.place(thing);
    face.look(
        thing.name(), at, next(execution, () -> face.point(thing.name(), at, ending(execution))));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
