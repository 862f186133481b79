package org.maestro.hal.ros;

import java.time.Duration;
import java.util.Optional;
import org.maestro.hal.Thermometer;

/** A thermometer behind ROS. Clock thread only. */
public final class RosThermometer implements Thermometer {

  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(60);
  private static final Duration PAUSE = Duration.ofSeconds(1);
  private static final double STEPS = 10;

  private final RosTopic<Double> topic;
  private Optional<RosTopic.Heard<Double>> told = Optional.empty();

  /**
   * @param topic tells sensor_msgs/Temperature; at least every minute
   */
  public RosThermometer(RosBridge bridge, String topic) {
    this.topic =
        bridge.listen(
            topic,
            RosType.TEMPERATURE,
            PAUSE,
            message -> message.number("temperature"),
            celsius -> {});
  }

  /** Why it tells nothing of now, one sentence for people. */
  public Optional<String> fault() {
    return topic.fault(LONGEST_SILENCE);
  }

  /** In tenths. Whoever asks before it has told anything has not heard {@link #fault}. */
  @Override
  public double celsius() {
    told = topic.last().or(() -> told);
    return told.map(now -> Math.round(now.value() * STEPS) / STEPS)
        .orElseThrow(() -> new IllegalStateException("The thermometer has told nothing yet."));
  }
}
