package org.maestro.device.tasks;

import org.maestro.hal.Switch;
import org.maestro.rats.member.Execution;

/** Switches an appliance on or off. */
final class SetSwitch extends DeviceProcedure {

  private static final double SECONDS = 1;

  private final Switch appliance;
  private final boolean on;

  SetSwitch(FeatureContext context, boolean on) {
    this.appliance = context.driver(Switch.class);
    this.on = on;
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    appliance.set(on, ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(appliance.isOn() == on ? 0 : SECONDS, 0);
  }
}
