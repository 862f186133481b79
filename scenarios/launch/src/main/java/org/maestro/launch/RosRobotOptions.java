package org.maestro.launch;

import java.util.Optional;
import org.maestro.assembly.RosPart;
import org.maestro.hal.ros.RosBase;
import org.maestro.ontology.home.Home;
import picocli.CommandLine.Option;

/** The robot behind a rosbridge server. */
final class RosRobotOptions {
  @Option(
      names = "--robot",
      paramLabel = "ID",
      description = "Which device of the home is the robot behind the server.")
  private Optional<String> robot = Optional.empty();

  @Option(
      names = "--at",
      paramLabel = "\"X Y DEGREES\"",
      description = "Where the robot stands and looks now, in the home's frame.")
  private Optional<String> at = Optional.empty();

  @Option(
      names = "--pose",
      paramLabel = "TOPIC",
      description =
          "Tells where the robot is in the home's frame (geometry_msgs/PoseWithCovarianceStamped),"
              + " such as /amcl_pose.")
  private Optional<String> pose = Optional.empty();

  @Option(
      names = "--velocity",
      paramLabel = "TOPIC",
      defaultValue = "/cmd_vel",
      description = "Takes its velocity (geometry_msgs/Twist); default ${DEFAULT-VALUE}.")
  private String velocity;

  @Option(
      names = "--stamped",
      description = "Its velocity is a geometry_msgs/TwistStamped instead.")
  private boolean stamped;

  @Option(
      names = "--odometry",
      paramLabel = "TOPIC",
      defaultValue = "/odom",
      description = "Tells its odometry (nav_msgs/Odometry); default ${DEFAULT-VALUE}.")
  private String odometry;

  Optional<RosPart> part(Home home) {
    if (robot.isEmpty()) {
      return Optional.empty();
    }
    if (at.isEmpty() && pose.isEmpty()) {
      throw CommandException.badInput(
          "Say where %s stands: --at \"X Y DEGREES\", or --pose TOPIC where something localizes it."
              .formatted(robot.get()));
    }
    return Optional.of(
        new RosPart.Robot(
            HomeDevice.named(robot.get(), home),
            new RosBase.Topics(
                RosCommand.topic(velocity),
                stamped,
                RosCommand.topic(odometry),
                pose.map(RosCommand::topic)),
            at.map(HomeDevice::standing)));
  }
}
