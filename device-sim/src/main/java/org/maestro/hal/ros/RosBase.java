package org.maestro.hal.ros;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.hal.Localization;
import org.maestro.hal.Twist;
import org.maestro.hal.WheelMotors;
import org.maestro.hal.wheels.DeadReckoning;
import org.maestro.hal.wheels.Stance;
import org.maestro.hal.wheels.VelocityCommands;
import org.maestro.hal.wheels.WheelGeometry;
import org.maestro.hal.wheels.WheeledBase;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * The wheels of a robot behind ROS, and where they have brought it: by odometry from where it is
 * known to have stood, and, where something localizes it, from each pose that this tells. Clock
 * thread only.
 */
public final class RosBase implements WheelMotors, Localization {

  /** Odometry is told ten times a second and more often. */
  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(2);

  /** Poses are told now and then, when the robot has moved. */
  private static final Duration POSES_STAY = Duration.ofDays(365);

  private static final Duration PAUSE = Duration.ofMillis(50);
  private static final Duration NO_PAUSE = Duration.ZERO;

  /** So much farther than it drives at full speed it is at most, if its odometry counts on. */
  private static final double ODOMETRY_ERROR = 1;

  private static final double NANOS = 1e9;

  private final RosBridge bridge;
  private final Topics topics;
  private final double speed;
  private final VelocityCommands commands;
  private final Predicate<Segment> isFree;
  private final RosTopic<Stance> odometry;
  private final Optional<RosTopic<Stance>> poses;
  private final Striving striving = new Striving();
  private Optional<DeadReckoning> reckoning;
  private Optional<RosTopic.Heard<Stance>> counted = Optional.empty();
  private long posed;
  private Optional<String> astray = Optional.empty();

  /**
   * The topics of a base.
   *
   * @param velocity takes geometry_msgs/Twist, or TwistStamped when {@code stamped}
   * @param odometry tells nav_msgs/Odometry
   * @param pose tells geometry_msgs/PoseWithCovarianceStamped in the home's frame
   */
  public record Topics(String velocity, boolean stamped, String odometry, Optional<String> pose) {
    RosType velocityType() {
      return stamped ? RosType.TWIST_STAMPED : RosType.TWIST;
    }
  }

  /**
   * @param start where the robot stands when its odometry is first heard; empty: where its pose
   *     says
   * @param speed the most it drives; metres a second
   * @param isFree whether it can go straight along there, as far as is known
   */
  public RosBase(
      RosBridge bridge,
      Topics topics,
      WheelGeometry geometry,
      Optional<Stance> start,
      double speed,
      Predicate<Segment> isFree,
      WheeledBase.Pace pace) {
    this.bridge = bridge;
    this.topics = topics;
    this.speed = speed;
    this.commands = new VelocityCommands(geometry, pace, this::tell);
    this.isFree = isFree;
    this.reckoning = start.map(DeadReckoning::new);
    bridge.advertise(topics.velocity(), topics.velocityType());
    this.odometry =
        bridge.listen(topics.odometry(), RosType.ODOMETRY, PAUSE, RosBase::stance, told -> {});
    this.poses =
        topics
            .pose()
            .map(
                topic -> bridge.listen(topic, RosType.POSE, NO_PAUSE, RosBase::stance, told -> {}));
  }

  private static Stance stance(RosFields message) {
    return message.in("pose").in("pose").stance();
  }

  @Override
  public void spin(List<Double> radiansPerSecond) {
    commands.spin(radiansPerSecond);
  }

  private void tell(Twist motion) {
    striving.told(motion);
    ObjectNode twist = bridge.message();
    twist.set("linear", vector(motion.forward(), motion.left(), 0));
    twist.set("angular", vector(0, 0, motion.turn()));
    ObjectNode message = twist;
    if (topics.stamped()) {
      message = bridge.message();
      message.set("twist", twist);
    }
    bridge.tell(topics.velocity(), message);
  }

  private ObjectNode vector(double x, double y, double z) {
    return bridge.message().put("x", x).put("y", y).put("z", z);
  }

  /** Why it is not known where the base is, or nothing can be told to it. */
  public Optional<String> silence() {
    follow();
    return odometry
        .fault(LONGEST_SILENCE)
        .or(() -> bridge.fault(topics.velocity(), topics.velocityType()))
        .or(() -> reckoning.isPresent() ? astray : poses.flatMap(p -> p.fault(POSES_STAY)));
  }

  @Override
  public Optional<String> fault() {
    return silence()
        .or(() -> odometry.last().flatMap(now -> striving.inVain(now.value(), now.atNanos())));
  }

  @Override
  public Point2 position() {
    return place().point();
  }

  @Override
  public double heading() {
    return place().heading();
  }

  /** Whoever asks before anything is known of it has not heard {@link #silence}. */
  private Stance place() {
    follow();
    return reckoning
        .map(DeadReckoning::now)
        .orElseThrow(() -> new IllegalStateException("It is not known yet where the robot is."));
  }

  private void follow() {
    odometry
        .last()
        .filter(now -> counted.filter(before -> before.number() == now.number()).isEmpty())
        .ifPresent(this::count);
    poses.flatMap(RosTopic::last).filter(pose -> pose.number() != posed).ifPresent(this::stand);
  }

  private void count(RosTopic.Heard<Stance> now) {
    counted.ifPresent(before -> requireNoJump(before, now));
    counted = Optional.of(now);
    reckoning.ifPresent(known -> known.tells(now.value()));
  }

  private void requireNoJump(RosTopic.Heard<Stance> before, RosTopic.Heard<Stance> now) {
    double metres = before.value().point().distance(now.value().point());
    double seconds = (now.atNanos() - before.atNanos()) / NANOS;
    if (metres > ODOMETRY_ERROR + 2 * speed * seconds) {
      astray =
          Optional.of(
              "The odometry on %s has jumped by %d m, so that it is not known any more where the robot is; begin again with where it stands."
                  .formatted(topics.odometry(), Math.round(metres)));
    }
  }

  private void stand(RosTopic.Heard<Stance> pose) {
    posed = pose.number();
    astray = Optional.empty();
    reckoning.ifPresentOrElse(
        known -> known.stands(pose.value()),
        () -> {
          DeadReckoning first = new DeadReckoning(pose.value());
          counted.ifPresent(now -> first.tells(now.value()));
          reckoning = Optional.of(first);
        });
  }

  @Override
  public boolean isFree(Segment ahead) {
    return isFree.test(ahead);
  }
}
