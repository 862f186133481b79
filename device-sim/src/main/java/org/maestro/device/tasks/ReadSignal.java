package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.hal.SignalField;
import org.maestro.rats.member.Execution;

/** Tells how strong the signal is where a robot is now. */
final class ReadSignal extends DeviceProcedure {

  private final SignalField field;

  ReadSignal(FeatureContext context) {
    this.field = context.driver(SignalField.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    field.read(
        parameters.pointer("robot").name(),
        new SignalField.Listener() {
          @Override
          public void measured(double strength) {
            execution.succeed(Map.of("strength", strength));
          }

          @Override
          public void failed(String reason) {
            execution.fail(FeatureContext.broken(reason));
          }
        });
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(field.seconds(), 0);
  }
}
