package org.maestro.device.tasks;

import java.util.Map;
import org.maestro.hal.Completion;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Steering;
import org.maestro.rats.member.Execution;

/**
 * Turns a robot on the spot, by as much as it is told. Its body is round, so that it touches
 * nothing meanwhile. On cancel it stands still.
 */
final class TurnTask extends DeviceProcedure {

  private final MobileBase base;
  private final Steering steering;
  private final Motion motion;

  TurnTask(FeatureContext context) {
    this.base = context.driver(MobileBase.class);
    this.steering = context.driver(Steering.class);
    this.motion = context.motion();
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    double radians = Math.toRadians(parameters.number("degrees"));
    motion.begin(
        () ->
            execution.fail(
                FeatureContext.broken(
                    "It was told to stand still while it turned; its front looks to %s degrees."
                        .formatted(Numbers.plain(degrees())))));
    execution.onCancel(
        safe -> {
          motion.over();
          base.stop();
          safe.run();
        });
    steering.turn(
        radians,
        new Completion() {
          @Override
          public void done() {
            motion.over();
            execution.succeed(Map.of("heading", degrees()));
          }

          @Override
          public void failed(String reason) {
            motion.over();
            execution.fail(FeatureContext.broken(reason));
          }
        });
  }

  private double degrees() {
    return Numbers.degreesAround(steering.heading());
  }

  @Override
  Estimate cost(CallParameters parameters) {
    double seconds = Math.abs(Math.toRadians(parameters.number("degrees"))) / steering.turnSpeed();
    return price(seconds, seconds * base.power());
  }
}
