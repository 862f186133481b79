package org.maestro.device.tasks;

import java.util.OptionalInt;
import org.maestro.hal.DimmableLamp;
import org.maestro.rats.member.Execution;

/** Turns a lamp to a level, and to a shade of white where one is given. */
final class AdjustLight extends DeviceProcedure {

  private static final double SECONDS = 0.4;

  private final DimmableLamp lamp;

  AdjustLight(FeatureContext context) {
    this.lamp = context.driver(DimmableLamp.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    double level = parameters.share("level");
    OptionalInt white =
        parameters.optionalNumber("white").stream().mapToInt(kelvin -> (int) kelvin).findFirst();
    lamp.set(level, white, ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    parameters.share("level");
    return price(SECONDS, 0);
  }
}
