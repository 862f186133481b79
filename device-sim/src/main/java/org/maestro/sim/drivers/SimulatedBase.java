package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.MobileBase;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.parameters.BaseData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Astray;
import org.maestro.sim.world.Drive;
import org.maestro.sim.world.Flaw;
import org.maestro.sim.world.Lookout;
import org.maestro.sim.world.World;

/**
 * A base that drives at full speed, less what it slips, and stands still before what comes in its
 * way.
 */
final class SimulatedBase implements MobileBase {

  /** However much it slips, it gets on. */
  private static final double MOST_SLIP = 0.95;

  private final Actuator actuator;
  private final BaseData data;
  private final double slip;
  private final Lookout lookout;
  private final Runnable look;
  private long driveNumber;

  /**
   * @param slip share of its way that is lost, standard deviation, anew at each look of the scanner
   * @param look what the scanner does besides
   */
  SimulatedBase(Actuator actuator, BaseData data, double slip, Runnable look) {
    this.actuator = actuator;
    this.data = data;
    this.slip = slip;
    this.look = look;
    this.lookout = new Lookout(actuator.world(), actuator.device(), data.radius());
  }

  @Override
  public Point2 position() {
    return actuator.world().faults().astray(actuator.device()).from(truth());
  }

  private Point2 truth() {
    return actuator.world().position(actuator.device()).orElseThrow().floor();
  }

  @Override
  public void drive(List<Point2> way, Completion completion) {
    stop();
    long number = ++driveNumber;
    actuator.command(
        WorldEvent.Kind.DRIVE,
        0,
        completion::failed,
        () -> {
          if (number == driveNumber && actuator.flaw().isStranded()) {
            pretend(way, number, completion);
          } else if (number == driveNumber) {
            roll(way, number, completion);
          }
        });
  }

  /** As long as the drive would take. */
  private void pretend(List<Point2> way, long number, Completion completion) {
    Drive drive = new Drive(actuator.clock().now(), position(), way, data.speed());
    actuator.after(
        drive.duration().toNanos() / 1e9,
        () -> {
          if (number == driveNumber) {
            if (actuator.flaw() == Flaw.SPINNING && !way.isEmpty()) {
              Point2 end = way.get(way.size() - 1);
              actuator.world().faults().lead(actuator.device(), Astray.between(truth(), end));
            }
            completion.done();
          }
        });
  }

  /** From here, as fast as the wheels grip now. */
  private void roll(List<Point2> way, long number, Completion completion) {
    double faultless = 1 - actuator.world().faults().slipOf(actuator.device());
    double grip = faultless * gripNow();
    if (grip <= 0) {
      actuator.world().whereabouts().stop(actuator.device());
      completion.failed("its wheels do not grip");
      return;
    }
    Drive drive = new Drive(actuator.clock().now(), position(), way, grip * data.speed());
    actuator.world().whereabouts().start(actuator.device(), drive);
    goOn(new Rolling(drive, faultless, actuator.clock().now()), number, completion);
  }

  /** Without slip chance is not asked. */
  private double gripNow() {
    return slip == 0 ? 1 : 1 - Math.min(MOST_SLIP, Math.abs(actuator.error(slip)));
  }

  /**
   * A drive, and what it was begun with.
   *
   * @param faultless grip that a fault left
   */
  private record Rolling(Drive drive, double faultless, Duration begun) {}

  private void goOn(Rolling rolling, long number, Completion completion) {
    Drive drive = rolling.drive();
    if (number != driveNumber
        || !actuator.world().whereabouts().drive(actuator.device()).equals(Optional.of(drive))) {
      return;
    }
    World world = actuator.world();
    Duration now = actuator.clock().now();
    boolean looksAgain = slip > 0 && now.compareTo(rolling.begun()) > 0;
    if (rolling.faultless() != 1 - world.faults().slipOf(actuator.device())
        || looksAgain && !drive.wayAhead(now).isEmpty()) {
      world.whereabouts().stop(actuator.device());
      roll(drive.wayAhead(now), number, completion);
      return;
    }
    look.run();
    lookout
        .touched()
        .ifPresent(
            other -> world.tell(WorldEvent.Kind.COLLIDED, actuator.device(), Optional.of(other)));
    double left = drive.begun().plus(drive.duration()).minus(now).toNanos() / 1e9;
    if (left <= 0) {
      actuator.world().whereabouts().stop(actuator.device());
      actuator.tell(WorldEvent.Kind.DRIVEN);
      completion.done();
    } else if (!lookout.isFree(drive.ahead(now, data.checkSeconds()), data.checkSeconds())) {
      actuator.world().whereabouts().stop(actuator.device());
      actuator.tell(WorldEvent.Kind.BLOCKED);
      completion.failed("something stands in the way");
    } else {
      actuator.after(Math.min(left, data.checkSeconds()), () -> goOn(rolling, number, completion));
    }
  }

  @Override
  public void stop() {
    driveNumber++;
    actuator.world().whereabouts().stop(actuator.device());
  }

  @Override
  public double speed() {
    return data.speed();
  }

  @Override
  public double radius() {
    return data.radius();
  }

  @Override
  public double power() {
    return data.power();
  }
}
