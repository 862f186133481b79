package org.maestro.assembly;

import java.time.Duration;
import org.maestro.device.DeviceMember;
import org.maestro.hal.Drivers;
import org.maestro.hal.player.PlayerBase;
import org.maestro.hal.player.PlayerConnection;
import org.maestro.hal.wheels.Stance;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;

/**
 * A robot behind a Player server as a device of a home (ADE, 3.3; A40). It knows the home's walls,
 * doors closed, and sees nothing of what stands on the floor. Any thread may close it.
 */
public final class PlayerRobot implements AutoCloseable {

  private static final Duration TELLS_EVERY = Duration.ofSeconds(1);

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
      Stance place,
      String site,
      SiteBus bus,
      Clock clock) {
    StatedBase stated = new StatedBase(home, device, clock);
    PlayerBase player =
        new PlayerBase(connection, stated.wheels(), place, stated.isFree(), stated.pace());
    Drivers drivers = stated.drivers(stated.on(player, player));
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
}
