package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.JammingGripper;
import org.maestro.sim.parameters.GripperData;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.Wrap;

/** A bag of grains that holds what it can wrap ({@link Wrap}). */
final class SimulatedJammingGripper implements JammingGripper {

  private static final double NANOS = 1e9;

  private final Actuator actuator;
  private final GripperData data;
  private final Grasp grasp;
  private final ArmMotion motion;
  private Ramp pressure = new Ramp(0, 0, Duration.ZERO, 0);

  SimulatedJammingGripper(Actuator actuator, GripperData data, Grasp grasp, double watts) {
    this.actuator = actuator;
    this.data = data;
    this.grasp = grasp;
    this.motion = new ArmMotion(actuator, watts);
  }

  /** A pressure that changes evenly; kilopascals. */
  private record Ramp(double from, double to, Duration begun, double seconds) {
    double at(Duration now) {
      double passed = now.minus(begun).toNanos() / NANOS;
      return passed >= seconds ? to : from + (to - from) * passed / seconds;
    }
  }

  @Override
  public void press(Completion completion) {
    motion.run(data.pressSeconds(), completion, Optional::empty);
  }

  @Override
  public void evacuate(Completion completion) {
    change(-data.vacuum(), data.evacuateSeconds());
    motion.run(data.evacuateSeconds(), completion, () -> grasp.take(this::failing));
  }

  private Optional<String> failing(Body thing) {
    return new Wrap(data, actuator.world().looks().size(thing.name())).failure(thing.mass());
  }

  /** The valve opens when the hand has felt room below. */
  @Override
  public void inflate(Completion completion) {
    motion.run(
        data.inflateSeconds(),
        completion,
        () -> {
          Optional<String> failure = grasp.putDown();
          if (grasp.held().isEmpty()) {
            change(0, 0);
          }
          return failure;
        });
  }

  private void change(double to, double seconds) {
    pressure = new Ramp(pressure(), to, actuator.clock().now(), seconds);
  }

  @Override
  public void stop() {
    motion.stop();
    change(pressure(), 0);
  }

  @Override
  public double pressure() {
    return pressure.at(actuator.clock().now());
  }

  @Override
  public boolean isEvacuated() {
    return pressure() <= -data.vacuum();
  }

  @Override
  public boolean isHolding() {
    return isEvacuated() && grasp.held().isPresent();
  }

  @Override
  public double opening() {
    return data.opening();
  }

  @Override
  public double gripSeconds() {
    return data.pressSeconds() + data.evacuateSeconds();
  }

  @Override
  public double inflateSeconds() {
    return data.inflateSeconds();
  }
}
