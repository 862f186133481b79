package org.maestro.hal.ros;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.fixtures.RosbridgeServer;
import org.maestro.hal.Completion;
import org.maestro.hal.wheels.DifferentialWheels;
import org.maestro.hal.wheels.Stance;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.time.PacedClock;

/** A base behind rosbridge drives as any other does (Three-layered architecture, 4.3; M89). */
class RosBaseTest {
  private static final WheeledBase.Limits LIMITS =
      new WheeledBase.Limits(0.8, 2, 0.25, 50, 0.1, 0.1, 0.05, 0.1);

  private final PacedClock clock = new PacedClock(1);
  private final DifferentialWheels wheels = new DifferentialWheels(0.1, 0.2);

  @AfterEach
  void close() {
    clock.close();
  }

  private RosBase ros(RosBridge bridge, Optional<String> pose, Optional<Stance> start) {
    RosBase.Topics topics = new RosBase.Topics("/cmd_vel", false, "/odom", pose);
    return new RosBase(bridge, topics, wheels, start, 0.8, ahead -> true, this::after);
  }

  private RosBase rosAt(RosBridge bridge, double x, double y, double heading) {
    return ros(bridge, Optional.empty(), Optional.of(new Stance(new Point2(x, y), heading)));
  }

  private WheeledBase base(RosBase ros) {
    return new WheeledBase(wheels, ros, ros, this::after, LIMITS);
  }

  private void after(double seconds, Runnable next) {
    clock.schedule(Duration.ofNanos(Math.round(seconds * 1e9)), "robot", next);
  }

  /** On the clock's thread. */
  private <T> T asked(Supplier<T> question) {
    CompletableFuture<T> answer = new CompletableFuture<>();
    after(0, () -> answer.complete(question.get()));
    return answer.orTimeout(30, TimeUnit.SECONDS).join();
  }

  private void awaitSilence(RosBase ros, String reason) {
    await(() -> asked(ros::silence).orElse("").contains(reason));
  }

  private void awaitTold(RosBase ros) {
    await(() -> asked(ros::silence).isEmpty());
  }

  private static void await(Callable<Boolean> condition) {
    Awaitility.await().atMost(Duration.ofSeconds(30)).until(condition);
  }

  /** Empty: it is done. */
  private Optional<String> ended(Consumer<Completion> drive) {
    CompletableFuture<Optional<String>> end = new CompletableFuture<>();
    after(
        0,
        () ->
            drive.accept(
                new Completion() {
                  @Override
                  public void done() {
                    end.complete(Optional.empty());
                  }

                  @Override
                  public void failed(String reason) {
                    end.complete(Optional.of(reason));
                  }
                }));
    return end.orTimeout(60, TimeUnit.SECONDS).join();
  }

  @Test
  void drivesAndTurnsInTheHomesFrame() {
    try (RosbridgeServer server = new RosbridgeServer(100, -50, 1);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_2)) {
      RosBase ros = rosAt(bridge, 3, 2, Math.PI / 2);
      awaitTold(ros);
      WheeledBase base = base(ros);

      assertThat(ended(done -> base.drive(List.of(new Point2(3, 3)), done))).isEmpty();
      assertThat(asked(base::position).distance(new Point2(3, 3))).isLessThan(0.15);

      assertThat(ended(done -> base.turn(-Math.PI / 2, done))).isEmpty();
      assertThat(asked(base::heading)).isCloseTo(0, within(0.1));
      await(() -> server.motion().matches("-?0.00 -?0.00"));
      assertThat(server.subscribed("/odom")).hasValue("nav_msgs/msg/Odometry");
    }
  }

  @Test
  void standsWhereItsPoseSaysAndGoesOnByOdometry() {
    try (RosbridgeServer server = new RosbridgeServer(0, 0, 0);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_2)) {
      RosBase ros = ros(bridge, Optional.of("/amcl_pose"), Optional.empty());
      awaitSilence(ros, "has told nothing on /amcl_pose yet");

      server.tell("/amcl_pose", "{\"pose\": %s}".formatted(RosbridgeServer.pose(4, 1, Math.PI)));
      awaitTold(ros);
      assertThat(asked(ros::position)).isEqualTo(new Point2(4, 1));

      WheeledBase base = base(ros);
      assertThat(ended(done -> base.drive(List.of(new Point2(3.6, 1)), done))).isEmpty();
      server.tell("/amcl_pose", "{\"pose\": %s}".formatted(RosbridgeServer.pose(3.5, 1, Math.PI)));
      await(() -> asked(base::position).distance(new Point2(3.5, 1)) < 0.01);
    }
  }

  @Test
  void ofRos1TheTypesAreCalledOtherwise() {
    try (RosbridgeServer server =
            new RosbridgeServer(0, "geometry_msgs/Twist", "nav_msgs/Odometry", 0, 0, 0);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_1)) {
      awaitTold(rosAt(bridge, 0, 0, 0));
    }
  }

  @Test
  void aTypeThatTheServerKnowsOtherwiseIsTold() {
    try (RosbridgeServer server =
            new RosbridgeServer(
                0, "geometry_msgs/msg/TwistStamped", "nav_msgs/msg/Odometry", 0, 0, 0);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_2)) {
      RosBase ros = rosAt(bridge, 0, 0, 0);
      awaitSilence(ros, "refuses /cmd_vel as geometry_msgs/msg/Twist: advertise: Tried to");

      assertThat(ended(done -> base(ros).drive(List.of(new Point2(1, 0)), done)).orElseThrow())
          .endsWith("already established with type geometry_msgs/msg/TwistStamped.");
    }
  }

  @Test
  void aBaseThatDoesNotMoveThoughItIsToldEndsTheDrive() {
    try (RosbridgeServer server = new RosbridgeServer(0, 0, 0);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_2)) {
      RosBase ros = rosAt(bridge, 0, 0, 0);
      awaitTold(ros);
      server.stall();
      assertThat(ended(done -> base(ros).drive(List.of(new Point2(5, 0)), done)).orElseThrow())
          .contains("its odometry says that it stands still");
    }
  }

  @Test
  void whoTellsNothingAnyMoreIsNotTrusted() {
    try (RosbridgeServer server = new RosbridgeServer(0, 0, 0);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_2)) {
      RosBase ros = rosAt(bridge, 0, 0, 0);
      awaitTold(ros);
      server.fallSilent();
      awaitSilence(ros, "has told nothing on /odom for more than 2 s");
    }
  }

  @Test
  void odometryThatJumpsIsNotBelieved() {
    try (RosbridgeServer server = new RosbridgeServer(0, 0, 0);
        RosBridge bridge = RosBridge.open(server.address(), RosVersion.ROS_2)) {
      RosBase ros = rosAt(bridge, 0, 0, 0);
      awaitTold(ros);
      server.fallSilent();
      server.tell("/odom", "{\"pose\": %s}".formatted(RosbridgeServer.pose(70, 0, 0)));
      awaitSilence(ros, "has jumped by 70 m");
    }
  }

  @Test
  void theConnectionThatBrokeIsMadeAnewAndTheDriveIsNot() {
    RosbridgeServer first = new RosbridgeServer(0, 0, 0);
    int port = first.address().getPort();
    try (RosBridge bridge = RosBridge.open(first.address(), RosVersion.ROS_2)) {
      RosBase ros = rosAt(bridge, 1, 1, 0);
      awaitTold(ros);
      WheeledBase base = base(ros);
      CompletableFuture<Optional<String>> drive =
          CompletableFuture.supplyAsync(
              () -> ended(done -> base.drive(List.of(new Point2(30, 1)), done)));
      await(() -> asked(base::position).x() > 1.1);
      first.close();
      assertThat(drive.join().orElseThrow())
          .contains("The rosbridge server ws://127.0.0.1:" + port);
      awaitSilence(ros, "nobody listens there");

      try (RosbridgeServer second =
          new RosbridgeServer(
              port, "geometry_msgs/msg/Twist", "nav_msgs/msg/Odometry", 0.3, 0, 0)) {
        awaitTold(ros);
        assertThat(asked(base::position).distance(new Point2(1.3, 1))).isLessThan(0.5);
        assertThat(second.motion()).isEqualTo("0.00 0.00");
        Point2 ahead = asked(base::position).plus(0.4, 0);
        assertThat(ended(done -> base.drive(List.of(ahead), done))).isEmpty();
      }
    }
  }
}
