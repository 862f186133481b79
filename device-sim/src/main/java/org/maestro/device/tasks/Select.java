package org.maestro.device.tasks;

import org.maestro.hal.Selector;
import org.maestro.rats.member.Execution;

/** Chooses something at an appliance. */
final class Select extends DeviceProcedure {

  private static final double SECONDS = 1;

  private final Selector appliance;

  Select(FeatureContext context) {
    this.appliance = context.driver(Selector.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    appliance.select(parameters.pointer("selection").name(), ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    parameters.pointer("selection");
    return price(SECONDS, 0);
  }
}
