package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.hal.Transmitter;
import org.maestro.rats.member.Execution;
import org.maestro.rats.protocol.RatsError;

/**
 * Sends what a robot has to send; where the signal is too weak it says how strong it would have to
 * be.
 */
final class TransmitTask extends DeviceProcedure {

  private final FeatureContext context;
  private final Transmitter transmitter;

  TransmitTask(FeatureContext context) {
    this.context = context;
    this.transmitter = context.driver(Transmitter.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    transmitter.transmit(
        new Transmitter.Listener() {
          @Override
          public void sent() {
            execution.succeed(Map.of());
          }

          @Override
          public void tooWeak(double strength) {
            execution.fail(weak(strength, parameters));
          }

          @Override
          public void failed(String reason) {
            execution.fail(FeatureContext.broken(reason));
          }
        });
  }

  private RatsError weak(double strength, CallParameters parameters) {
    String needed = Numbers.plain(transmitter.neededStrength());
    return FeatureContext.unmet(
        "The signal is %s here, and has to be %s at least."
            .formatted(Numbers.plain(strength), needed),
        "transmit from where the signal is stronger",
        context.reference("signal", parameters, Map.of(), ">= " + needed, strength).stream()
            .toList());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(transmitter.seconds(), 0);
  }
}
