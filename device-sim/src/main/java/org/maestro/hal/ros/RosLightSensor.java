package org.maestro.hal.ros;

import java.time.Duration;
import java.util.Optional;
import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.wheels.WheeledBase;

/**
 * A light sensor behind ROS. A reading is one that comes after it was asked for, so that it shows
 * the light of then. Clock thread only.
 */
public final class RosLightSensor implements IlluminationSensor {

  private static final Duration LONGEST_SILENCE = Duration.ofSeconds(10);
  private static final Duration PAUSE = Duration.ofMillis(100);
  private static final double LOOKS_EVERY_SECONDS = 0.05;

  private final RosTopic<Double> topic;
  private final WheeledBase.Pace pace;

  /**
   * @param topic tells sensor_msgs/Illuminance; at least every ten seconds
   */
  public RosLightSensor(RosBridge bridge, String topic, WheeledBase.Pace pace) {
    this.topic =
        bridge.listen(
            topic, RosType.ILLUMINANCE, PAUSE, message -> message.amount("illuminance"), lux -> {});
    this.pace = pace;
  }

  /** Why it cannot be read now, one sentence for people. */
  public Optional<String> fault() {
    return topic.fault(LONGEST_SILENCE);
  }

  @Override
  public void read(Listener listener) {
    await(topic.last().map(RosTopic.Heard::number).orElse(0L), listener);
  }

  private void await(long before, Listener listener) {
    Optional<String> fault = fault();
    Optional<RosTopic.Heard<Double>> next = topic.last().filter(now -> now.number() > before);
    if (fault.isPresent()) {
      listener.failed(fault.get());
    } else if (next.isPresent()) {
      listener.measured(next.get().value());
    } else {
      pace.after(LOOKS_EVERY_SECONDS, () -> await(before, listener));
    }
  }
}
