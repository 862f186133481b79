package org.maestro.hal.player;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.hal.Localization;
import org.maestro.hal.Twist;
import org.maestro.hal.WheelMotors;
import org.maestro.hal.wheels.WheelGeometry;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * The wheels of a robot behind a Player server, and where they have brought it: by odometry from
 * where it stood when it was first heard of. Where the server begins to count anew, it goes on from
 * where the robot was. Clock thread only.
 */
public final class PlayerBase implements WheelMotors, Localization {

  /** As {@link WheelMotors} says. */
  private static final double WATCHDOG_SECONDS = 1;

  private final PlayerConnection connection;
  private final WheelGeometry geometry;
  private final Predicate<Segment> isFree;
  private final WheeledBase.Pace pace;
  private Place start;
  private Place now;
  private int counted;
  private PlayerConnection.Odometry since = new PlayerConnection.Odometry(0, 0, 0);
  private long commands;

  /**
   * Where a robot stands and looks, in the home's frame.
   *
   * @param heading radians
   */
  public record Place(Point2 point, double heading) {}

  /**
   * @param start where the robot stands when it is first heard of
   * @param isFree whether it can go straight along there, as far as is known
   */
  public PlayerBase(
      PlayerConnection connection,
      WheelGeometry geometry,
      Place start,
      Predicate<Segment> isFree,
      WheeledBase.Pace pace) {
    this.connection = connection;
    this.geometry = geometry;
    this.start = start;
    this.now = start;
    this.isFree = isFree;
    this.pace = pace;
  }

  @Override
  public void spin(List<Double> radiansPerSecond) {
    long number = ++commands;
    Twist motion = geometry.motion(radiansPerSecond);
    connection.command(motion);
    if (!motion.equals(Twist.STILL)) {
      pace.after(WATCHDOG_SECONDS, () -> standStillUnlessToldSince(number));
    }
  }

  private void standStillUnlessToldSince(long number) {
    if (number == commands) {
      connection.command(Twist.STILL);
    }
  }

  @Override
  public Optional<String> fault() {
    return connection.fault();
  }

  @Override
  public Point2 position() {
    return place().point();
  }

  @Override
  public double heading() {
    return place().heading();
  }

  private Place place() {
    connection.told().ifPresent(this::follow);
    return now;
  }

  private void follow(PlayerConnection.Told told) {
    if (told.connection() != counted) {
      counted = told.connection();
      since = told.odometry();
      start = now;
    }
    double turned = start.heading() - since.heading();
    double x = told.odometry().x() - since.x();
    double y = told.odometry().y() - since.y();
    now =
        new Place(
            new Point2(
                start.point().x() + x * Math.cos(turned) - y * Math.sin(turned),
                start.point().y() + x * Math.sin(turned) + y * Math.cos(turned)),
            told.odometry().heading() + turned);
  }

  @Override
  public boolean isFree(Segment ahead) {
    return isFree.test(ahead);
  }
}
