package org.maestro.sim.drivers;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.maestro.hal.Completion;
import org.maestro.hal.Face;
import org.maestro.hal.FaceMount;
import org.maestro.hal.FaceState;
import org.maestro.hal.FacialExpression;
import org.maestro.hal.Gaze;
import org.maestro.hal.HeadGesture;
import org.maestro.hal.Position;
import org.maestro.sim.parameters.FaceData;
import org.maestro.sim.scene.WorldEvent;

/**
 * A robot's head and hand, whose motors take their time, as the paper's torso has them (ADE, 3.3;
 * A41).
 */
final class SimulatedFace implements Face {
  private final Actuator actuator;
  private final FaceMount mount;
  private final FaceData data;
  private FaceState state = FaceState.AT_REST;

  SimulatedFace(Actuator actuator, FaceMount mount, FaceData data) {
    this.actuator = actuator;
    this.mount = mount;
    this.data = data;
  }

  @Override
  public FaceState state() {
    return state;
  }

  /** What it is called on its front takes no motor. */
  @Override
  public void appear(String persona, Completion completion) {
    after(0, now -> now.of(persona), completion);
  }

  @Override
  public void express(FacialExpression expression, double intensity, Completion completion) {
    after(data.expressionSeconds(), now -> now.with(expression, intensity), completion);
  }

  @Override
  public void look(String thing, Position at, Completion completion) {
    Gaze gaze = mount.towards(thing, at);
    after(seconds(gaze), now -> now.looking(Optional.of(gaze)), completion);
  }

  /** Neck and eyes turn and rise at the same time. */
  private double seconds(Gaze wanted) {
    double turn = Math.abs(wanted.turn() - state.gaze().map(Gaze::turn).orElse(0.0));
    double rise = Math.abs(wanted.rise() - state.gaze().map(Gaze::rise).orElse(0.0));
    return Math.max(turn, rise) / data.turnSpeed();
  }

  @Override
  public void gesture(HeadGesture gesture, Completion completion) {
    during(
        data.gestureSeconds(),
        now -> now.moving(Optional.of(gesture)),
        now -> now.moving(Optional.empty()),
        completion);
  }

  @Override
  public void point(String thing, Position at, Completion completion) {
    Gaze there = mount.towards(thing, at);
    during(
        data.pointingSeconds(),
        now -> now.pointing(Optional.of(there)),
        now -> now.pointing(Optional.empty()),
        completion);
  }

  @Override
  public void say(String text, double stress, Completion completion) {
    during(
        seconds(text, stress),
        now -> now.saying(Optional.of(new FaceState.Spoken(text, stress))),
        now -> now.saying(Optional.empty()),
        completion);
  }

  private void after(double seconds, UnaryOperator<FaceState> change, Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        seconds,
        completion::failed,
        () -> {
          become(change);
          completion.done();
        });
  }

  /** A motor that is stuck at the beginning does not begin. */
  private void during(
      double seconds,
      UnaryOperator<FaceState> begin,
      UnaryOperator<FaceState> end,
      Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        0,
        completion::failed,
        () -> {
          become(begin);
          actuator.after(
              seconds,
              () -> {
                become(end);
                completion.done();
              });
        });
  }

  private void become(UnaryOperator<FaceState> change) {
    if (!actuator.flaw().isIdle()) {
      state = change.apply(state);
    }
    actuator.tell(WorldEvent.Kind.FACED);
  }
}
