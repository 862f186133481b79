package org.maestro.device.tasks;

import org.maestro.hal.Face;
import org.maestro.hal.HeadGesture;
import org.maestro.rats.member.Execution;

/** Has a face nod, or shake its head. */
final class MoveHead extends DeviceProcedure {
  private static final double SECONDS = 0.9;

  private final Face face;
  private final HeadGesture gesture;

  MoveHead(FeatureContext context, HeadGesture gesture) {
    this.face = context.driver(Face.class);
    this.gesture = gesture;
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    face.gesture(gesture, ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
