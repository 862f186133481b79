package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import org.maestro.hal.Microphone;
import org.maestro.hal.Sound;
import org.maestro.sim.parameters.SpeechData;
import org.maestro.sim.world.Talk;

/**
 * A microphone that records its zone: noise always, and a hum of a voice's pitch while a person
 * speaks there, since words have no sound in this world (assumed).
 */
final class SimulatedMicrophone implements Microphone, Talk.Listener {
  private static final int RATE = 16_000;
  private static final double STRETCH_SECONDS = 0.1;
  private static final double NANOS = 1e9;

  /** Share of the full scale that a quiet room's noise has; assumed. */
  private static final double NOISE = 0.002;

  /** The same of a voice; assumed. */
  private static final double VOICE = 0.2;

  /** The same of a tone; assumed. */
  private static final double TONE = 0.25;

  /** Pitch of a voice; assumed. */
  private static final double VOICE_HERTZ = 120;

  private final Actuator actuator;
  private final SpeechData speech;
  private final String zone;
  private final Random noise;
  private Duration voiceUntil = Duration.ZERO;

  private SimulatedMicrophone(Actuator actuator, SpeechData speech, String zone, long seed) {
    this.actuator = actuator;
    this.speech = speech;
    this.zone = zone;
    // Of its own, so that what else the device does by chance goes as without a stream.
    this.noise = new Random(~seed);
  }

  /** It can record from now on. */
  static SimulatedMicrophone start(Actuator actuator, SpeechData speech, String zone, long seed) {
    SimulatedMicrophone microphone = new SimulatedMicrophone(actuator, speech, zone, seed);
    actuator.world().talk().listen(microphone);
    return microphone;
  }

  @Override
  public int rate() {
    return RATE;
  }

  @Override
  public Runnable record(OptionalDouble testTone, Listener listener) {
    Course course = new Course(testTone, listener);
    course.next();
    return () -> course.isOver = true;
  }

  @Override
  public void begins(String person, Optional<String> where, List<String> words) {
    if (where.filter(zone::equals).isPresent()) {
      double seconds = words.size() * speech.wordSeconds();
      voiceUntil = actuator.clock().now().plusNanos(Math.round(seconds * NANOS));
    }
  }

  /** One listener's recording. */
  private final class Course {
    private final OptionalDouble tone;
    private final Listener listener;
    private long recorded;
    private boolean isOver;

    Course(OptionalDouble tone, Listener listener) {
      this.tone = tone;
      this.listener = listener;
    }

    void next() {
      actuator.after(
          STRETCH_SECONDS,
          () -> {
            Optional<String> defect = actuator.world().faults().defect(actuator.device());
            if (isOver) {
              return;
            }
            if (defect.isPresent()) {
              listener.failed(defect.get());
              return;
            }
            listener.recorded(stretch());
            next();
          });
    }

    private Sound stretch() {
      short[] samples = new short[(int) Math.round(RATE * STRETCH_SECONDS)];
      boolean isSpoken = actuator.clock().now().compareTo(voiceUntil) < 0;
      for (int i = 0; i < samples.length; i++) {
        double seconds = (double) recorded++ / RATE;
        double level =
            NOISE * noise.nextGaussian()
                + (isSpoken ? VOICE * wave(VOICE_HERTZ, seconds) : 0)
                + (tone.isPresent() ? TONE * wave(tone.getAsDouble(), seconds) : 0);
        samples[i] = (short) Math.round(Short.MAX_VALUE * Math.max(-1, Math.min(1, level)));
      }
      return new Sound(RATE, samples);
    }

    private static double wave(double hertz, double seconds) {
      return Math.sin(2 * Math.PI * hertz * seconds);
    }
  }
}
