package org.maestro.assembly;

import java.nio.ByteBuffer;
import java.nio.ShortBuffer;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.rats.protocol.StreamFrame;

/**
 * How strong sound of one channel is, as a share of what its samples hold, and how high: the pitch
 * counts how often it goes through zero, which is that of a single tone.
 */
final class SoundMeasures implements FrameMeasures {
  private static final Pattern LINEAR =
      Pattern.compile("audio/L16;rate=([1-9][0-9]{0,5});channels=1");

  /** What is weaker has no pitch. */
  private static final double SILENCE = 0.01;

  @Override
  public Map<String, Double> of(StreamFrame frame) {
    Matcher type = LINEAR.matcher(frame.mediaType());
    ShortBuffer samples = ByteBuffer.wrap(frame.data()).asShortBuffer();
    if (!type.matches() || !samples.hasRemaining()) {
      throw new IllegalArgumentException("it is no sound that is known here");
    }
    double power = 0;
    int rises = 0;
    for (int i = 0; i < samples.limit(); i++) {
      double sample = samples.get(i) / (double) Short.MAX_VALUE;
      power += sample * sample;
      rises += i > 0 && samples.get(i - 1) < 0 && samples.get(i) >= 0 ? 1 : 0;
    }
    double strength = Math.min(1, Math.sqrt(power / samples.limit()));
    double hertz = rises * Double.parseDouble(type.group(1)) / samples.limit();
    return Map.of("strength", strength, "pitch", strength < SILENCE ? 0 : hertz);
  }
}
