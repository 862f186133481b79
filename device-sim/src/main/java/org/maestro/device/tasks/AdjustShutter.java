package org.maestro.device.tasks;

import org.maestro.hal.ShutterDrive;
import org.maestro.rats.member.Execution;

/** Moves a shutter to an opening. */
final class AdjustShutter extends DeviceProcedure {

  private static final double SECONDS_FOR_WHOLE_WAY = 8;

  private final ShutterDrive shutter;

  AdjustShutter(FeatureContext context) {
    this.shutter = context.driver(ShutterDrive.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    shutter.setOpening(parameters.share("opening"), ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    double way = Math.abs(parameters.share("opening") - shutter.opening());
    return price(way * SECONDS_FOR_WHOLE_WAY, 0);
  }
}
