package org.maestro.assembly;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.maestro.device.DeviceMember;
import org.maestro.hal.ros.RosBridge;
import org.maestro.ontology.home.DescriptionWriter;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.time.Clock;

/**
 * Robots, sensors and cameras behind ROS as devices of a home (Three-layered architecture, 4.3;
 * M89). Each joins the site when its hardware is first heard. Any thread may close it.
 */
public final class RosDevices implements AutoCloseable {
  private static final Duration RESTS_WITHIN = Duration.ofSeconds(2);

  private final RosBridge bridge;
  private final List<RosMember> members;
  private final Clock clock;

  private RosDevices(RosBridge bridge, List<RosMember> members, Clock clock) {
    this.bridge = bridge;
    this.members = List.copyOf(members);
    this.clock = clock;
  }

  /**
   * Begins to listen to what stands behind the server.
   *
   * @param bridge closed with them, once robots have been told to stand still
   * @param site name of the site on the bus
   * @throws org.maestro.device.tasks.DeviceSetupException with one sentence when a device offers
   *     what its part cannot do
   */
  public static RosDevices start(
      Home home, RosBridge bridge, List<RosPart> parts, String site, SiteBus bus, Clock clock) {
    List<RosMember> members = new ArrayList<>();
    for (RosPart part : parts) {
      Device device = part.device();
      RosHardware hardware = RosHardware.of(part, home, bridge, clock);
      DeviceMember described =
          DeviceMember.of(
              device, hardware.drivers(), clock, new DescriptionWriter(home).write(device));
      members.add(
          new RosMember(
              described,
              hardware,
              values ->
                  RatsMember.start(
                      described.profile(),
                      values,
                      bus.transports().apply(device.id()),
                      site,
                      bus.policy(),
                      clock),
              clock));
    }
    members.forEach(RosMember::begin);
    return new RosDevices(bridge, members, clock);
  }

  /** Robots stand still, and all leave the site; waits some seconds at most. */
  @Override
  public void close() {
    CountDownLatch ended = new CountDownLatch(1);
    clock.schedule(
        Duration.ZERO,
        "ros",
        () -> {
          members.forEach(RosMember::end);
          ended.countDown();
        });
    try {
      if (ended.await(RESTS_WITHIN.toMillis(), TimeUnit.MILLISECONDS)) {
        members.forEach(RosMember::close);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    bridge.close();
  }
}
