package org.maestro.hal.player;

import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.hal.Localization;
import org.maestro.hal.WheelMotors;
import org.maestro.hal.wheels.DeadReckoning;
import org.maestro.hal.wheels.Stance;
import org.maestro.hal.wheels.VelocityCommands;
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

  private final PlayerConnection connection;
  private final VelocityCommands commands;
  private final Predicate<Segment> isFree;
  private final DeadReckoning reckoning;
  private int counted;

  /**
   * @param start where the robot stands when it is first heard of
   * @param isFree whether it can go straight along there, as far as is known
   */
  public PlayerBase(
      PlayerConnection connection,
      WheelGeometry geometry,
      Stance start,
      Predicate<Segment> isFree,
      WheeledBase.Pace pace) {
    this.connection = connection;
    this.commands = new VelocityCommands(geometry, pace, connection::command);
    this.reckoning = new DeadReckoning(start);
    this.isFree = isFree;
  }

  @Override
  public void spin(List<Double> radiansPerSecond) {
    commands.spin(radiansPerSecond);
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

  private Stance place() {
    connection.told().ifPresent(this::follow);
    return reckoning.now();
  }

  private void follow(PlayerConnection.Told told) {
    if (told.connection() != counted) {
      counted = told.connection();
      reckoning.beginsAnew();
    }
    reckoning.tells(told.odometry());
  }

  @Override
  public boolean isFree(Segment ahead) {
    return isFree.test(ahead);
  }
}
