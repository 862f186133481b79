package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.hal.MobileBase;
import org.maestro.rats.member.Execution;

/** Has the base stand still, whichever feature has it drive or turn; who stands still is done. */
final class HaltTask extends DeviceProcedure {

  private static final double SECONDS = 0.1;

  private final MobileBase base;
  private final Motion motion;

  HaltTask(FeatureContext context) {
    this.base = context.driver(MobileBase.class);
    this.motion = context.motion();
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    base.stop();
    motion.halt();
    execution.succeed(Map.of());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
