package org.maestro.device.tasks;

import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.hal.Microphone;
import org.maestro.hal.Sound;
import org.maestro.rats.member.Execution;

/**
 * Streams what a microphone records until ended (ADE, 3.3; A44), in 16 bits as RFC 2586 has them,
 * with a test tone if one is wished.
 */
final class StreamSound extends DeviceProcedure {
  private static final double SECONDS = 0.1;
  private static final double LOWEST_HERTZ = 20;

  private final FeatureContext context;
  private final Microphone microphone;

  StreamSound(FeatureContext context) {
    this.context = context;
    this.microphone = context.driver(Microphone.class);
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    OptionalDouble tone = tone(parameters);
    Course course = new Course(execution);
    execution.established(Map.of("rate", microphone.rate()));
    course.stop = microphone.record(tone, course);
  }

  private OptionalDouble tone(CallParameters parameters) {
    OptionalDouble tone = parameters.optionalNumber("tone");
    double highest = microphone.rate() / 2.0;
    if (tone.isPresent() && (tone.getAsDouble() < LOWEST_HERTZ || tone.getAsDouble() >= highest)) {
      throw new InvalidCallException(
          "The parameter tone lies between %s and %s Hz, but is %s."
              .formatted(LOWEST_HERTZ, highest, tone.getAsDouble()));
    }
    return tone;
  }

  /** One call that streams. */
  private final class Course implements Microphone.Listener {
    private final Execution execution;
    private Runnable stop = () -> {};

    Course(Execution execution) {
      this.execution = execution;
    }

    @Override
    public void recorded(Sound sound) {
      if (execution.ended()) {
        stop.run();
      } else {
        Duration begun = context.clock().now().minusNanos(sound.nanos());
        execution.streamed(begun, mediaType(sound), bytes(sound));
      }
    }

    @Override
    public void failed(String reason) {
      stop.run();
      if (!execution.ended()) {
        execution.fail(FeatureContext.broken(reason));
      }
    }
  }

  private static String mediaType(Sound sound) {
    return "audio/L16;rate=%d;channels=1".formatted(sound.rate());
  }

  private static byte[] bytes(Sound sound) {
    short[] samples = sound.samples();
    ByteBuffer bytes = ByteBuffer.allocate(2 * samples.length);
    bytes.asShortBuffer().put(samples);
    return bytes.array();
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(SECONDS, 0);
  }
}
