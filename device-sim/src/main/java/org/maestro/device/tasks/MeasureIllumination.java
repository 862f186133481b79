package org.maestro.device.tasks;

import java.time.Duration;
import java.util.Map;
import org.maestro.hal.IlluminationSensor;
import org.maestro.rats.member.Execution;

/**
 * Measures the light at the sensor, and goes on until ended: the first value establishes, the
 * others are its stream.
 */
final class MeasureIllumination extends DeviceProcedure {

  private static final double SECONDS = 0.5;

  private final FeatureContext context;
  private final IlluminationSensor sensor;
  private final Duration period;

  MeasureIllumination(FeatureContext context) {
    this.context = context;
    this.sensor = context.driver(IlluminationSensor.class);
    this.period = Streams.period(context.feature());
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    measure(execution, true);
  }

  private void measure(Execution execution, boolean first) {
    if (execution.ended()) {
      return;
    }
    Duration begun = context.clock().now();
    sensor.read(
        new IlluminationSensor.Listener() {
          @Override
          public void measured(double lux) {
            report(context.feature(), execution, Map.of("lux", lux), first);
            Streams.next(context, begun, period, () -> measure(execution, false));
          }

          @Override
          public void failed(String reason) {
            execution.fail(FeatureContext.broken(reason));
          }
        });
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
