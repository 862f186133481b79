package org.maestro.assembly;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.maestro.device.DeviceMember;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.hal.Area;
import org.maestro.hal.Drivers;
import org.maestro.hal.MobileBase;
import org.maestro.hal.Steering;
import org.maestro.hal.Surroundings;
import org.maestro.hal.player.PlayerBase;
import org.maestro.hal.player.PlayerConnection;
import org.maestro.hal.wheels.DifferentialWheels;
import org.maestro.hal.wheels.MecanumWheels;
import org.maestro.hal.wheels.WheelGeometry;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;
import org.maestro.sim.world.FloorMap;
import org.maestro.sl.Term;

/**
 * A robot behind a Player server as a device of a home (ADE, 3.3; A40). It knows the home's walls,
 * doors closed, and sees nothing of what stands on the floor. Any thread may close it.
 */
public final class PlayerRobot implements AutoCloseable {

  /** Of a robot of which the home states nothing; assumed, such that it does no harm. */
  private static final double USUAL_SPEED = 0.4;

  private static final double USUAL_TURN_DEGREES = 45;
  private static final double USUAL_RADIUS = 0.3;

  /** Watts while driving; assumed, as no server tells it. */
  private static final double POWER = 50;

  /** Of the control: seconds between two commands, and how exactly corners are met; assumed. */
  private static final double CONTROL_SECONDS = 0.1;

  private static final double NEAR_METRES = 0.05;
  private static final double AIM_RADIANS = 0.1;

  private static final Duration TELLS_EVERY = Duration.ofSeconds(1);
  private static final double NANOS = 1e9;

  private final RatsMember member;
  private final Clock clock;
  private volatile boolean closed;

  private PlayerRobot(RatsMember member, Clock clock) {
    this.member = member;
    this.clock = clock;
  }

  /**
   * The robot joins the site; it can be used as soon as its server answers.
   *
   * @param connection stays open when the robot leaves
   * @param place where the robot stands when its server is first heard
   * @param site name of the site on the bus
   * @throws org.maestro.device.tasks.DeviceSetupException with one sentence when the device offers
   *     what a base alone cannot do
   */
  public static PlayerRobot start(
      Home home,
      Device device,
      PlayerConnection connection,
      PlayerBase.Place place,
      String site,
      SiteBus bus,
      Clock clock) {
    HomeFloor floor = new HomeFloor(home);
    WheeledBase base = base(device, connection, place, floor, pace(device, clock));
    Drivers drivers =
        Drivers.none()
            .with(MobileBase.class, base)
            .with(Steering.class, base)
            .with(Surroundings.class, floor);
    DeviceMember described =
        DeviceMember.of(device, drivers, clock, new DescriptionWriter(home).write(device));
    RatsMember member =
        RatsMember.start(
            described.profile(),
            described.values(),
            bus.transports().apply(device.id()),
            site,
            bus.policy(),
            clock);
    PlayerRobot robot = new PlayerRobot(member, clock);
    robot.tellNowAndThen();
    return robot;
  }

  private static WheeledBase.Pace pace(Device device, Clock clock) {
    return (seconds, next) ->
        clock.schedule(Duration.ofNanos(Math.round(seconds * NANOS)), device.id(), next);
  }

  private static WheeledBase base(
      Device device,
      PlayerConnection connection,
      PlayerBase.Place place,
      HomeFloor floor,
      WheeledBase.Pace pace) {
    WheelGeometry wheels = wheels(device);
    double radius = stated(device, "bodyRadius", USUAL_RADIUS);
    PlayerBase player =
        new PlayerBase(connection, wheels, place, ahead -> floor.isFree(ahead, radius), pace);
    return new WheeledBase(
        wheels,
        player,
        player,
        pace,
        new WheeledBase.Limits(
            stated(device, "speed", USUAL_SPEED),
            Math.toRadians(stated(device, "turnSpeed", USUAL_TURN_DEGREES)),
            radius,
            POWER,
            CONTROL_SECONDS,
            NEAR_METRES,
            AIM_RADIANS));
  }

  /** The server takes velocities, so that the wheels' measures cancel out. */
  private static WheelGeometry wheels(Device device) {
    boolean drivesToTheSide =
        device
            .individual()
            .properties()
            .getOrDefault("wheels", List.of())
            .contains(new Term.Text("mecanum"));
    return drivesToTheSide ? new MecanumWheels(1, 1, 1) : new DifferentialWheels(1, 1);
  }

  private static double stated(Device device, String property, double otherwise) {
    return FloorMap.number(device.individual(), property).orElse(otherwise);
  }

  private void tellNowAndThen() {
    if (!closed) {
      member.stateChanged();
      clock.schedule(TELLS_EVERY, member.id(), this::tellNowAndThen);
    }
  }

  @Override
  public void close() {
    closed = true;
    member.leave();
    member.close();
  }

  /** The floor as the home's file has it. */
  private static final class HomeFloor implements Surroundings {
    private final List<Segment> walls;
    private final List<Area> areas;

    HomeFloor(Home home) {
      FloorMap map = new FloorMap(home);
      this.walls = map.plan(Set.of()).walls();
      this.areas = map.areas();
    }

    boolean isFree(Segment ahead, double radius) {
      Point2 from = ahead.from();
      return new RoutePlanner(new WalledFloor(walls, radius), List.of())
          .isFreeWay(from, ahead.to());
    }

    @Override
    public List<Segment> walls() {
      return walls;
    }

    @Override
    public List<Obstacle> obstacles() {
      return List.of();
    }

    @Override
    public List<Area> areas() {
      return areas;
    }
  }
}
