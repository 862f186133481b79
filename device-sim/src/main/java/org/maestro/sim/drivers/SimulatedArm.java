package org.maestro.sim.drivers;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.hal.Completion;
import org.maestro.hal.GripperArm;
import org.maestro.hal.Hand;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.sim.parameters.ArmData;
import org.maestro.sim.scene.WorldEvent;

/** An arm with some hand at its end. */
public final class SimulatedArm implements GripperArm {

  /** The base stands where it was sent; the arm evens out so much of distance. */
  public static final double SLACK_METRES = 0.06;

  /** How high an arm reaches of which nobody says it, on a base as low as a youBot's; assumed. */
  private static final double USUAL_HEIGHT_METRES = 0.6;

  private final Actuator actuator;
  private final ArmData data;
  private final Grasp grasp;
  private final Hand hand;
  private final ArmMotion motion;
  private final OptionalDouble height;
  private Optional<Boast> boast = Optional.empty();

  /** A false report of the thing that the hand holds, or of an empty hand. */
  private record Boast(Optional<String> held) {}

  /**
   * @param height above the floor up to which it reaches, where there is a limit; metres
   */
  SimulatedArm(Actuator actuator, ArmData data, OptionalDouble height, Grasp grasp, Hand hand) {
    this.actuator = actuator;
    this.data = data;
    this.height = height;
    this.grasp = grasp;
    this.hand = hand;
    this.motion = new ArmMotion(actuator, data.power());
  }

  @Override
  public void extend(Position place, Completion completion) {
    hand.stop();
    motion.run(
        data.extendSeconds(),
        completion,
        () -> {
          Position there = actuator.world().faults().astray(actuator.device()).reached(place);
          if (robot().floor().distance(there.floor()) > data.reach() + SLACK_METRES) {
            return Optional.of("it is out of reach");
          }
          if (place.z() > height.orElse(USUAL_HEIGHT_METRES)) {
            return Optional.of("it is higher than the arm reaches");
          }
          grasp.moveTo(there);
          return Optional.empty();
        });
  }

  @Override
  public void open(Completion completion) {
    withHand(completion, hand::open);
  }

  @Override
  public void grasp(Target target, Completion completion) {
    actuator.tell(WorldEvent.Kind.GRASP);
    grasp.aimAt(target.name());
    withHand(
        completion,
        telling ->
            pretendOr(hand::close, hand.closeSeconds(), Optional.of(target.name()), telling));
  }

  @Override
  public boolean isPlaceFree() {
    return grasp.isPlaceFree();
  }

  @Override
  public void release(Completion completion) {
    actuator.tell(WorldEvent.Kind.RELEASE);
    withHand(
        completion,
        telling -> pretendOr(hand::letGo, hand.letGoSeconds(), Optional.empty(), telling));
  }

  private void pretendOr(
      Consumer<Completion> command, double seconds, Optional<String> held, Completion completion) {
    if (!actuator.flaw().isIdle()) {
      boast = Optional.empty();
      command.accept(completion);
      return;
    }
    motion.run(
        seconds,
        completion,
        () -> {
          boast = Optional.of(new Boast(held));
          return Optional.empty();
        });
  }

  private void withHand(Completion completion, Consumer<Completion> command) {
    motion.stop();
    hand.stop();
    command.accept(completion);
  }

  @Override
  public void fold(Completion completion) {
    hand.stop();
    motion.run(data.foldSeconds(), completion, Optional::empty);
  }

  private Position robot() {
    return actuator.world().position(actuator.device()).orElseThrow();
  }

  @Override
  public Optional<String> held() {
    return boast
        .filter(told -> actuator.flaw().repeatsOrders())
        .map(Boast::held)
        .orElseGet(grasp::held);
  }

  @Override
  public double reach() {
    return data.reach();
  }

  @Override
  public double payload() {
    return data.payload();
  }

  @Override
  public double opening() {
    return hand.opening();
  }

  @Override
  public double pickSeconds() {
    return data.extendSeconds() + hand.closeSeconds() + data.foldSeconds();
  }

  @Override
  public double placeSeconds() {
    return data.extendSeconds() + hand.letGoSeconds() + data.foldSeconds();
  }

  @Override
  public double power() {
    return data.power();
  }
}
