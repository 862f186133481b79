package org.maestro.device.tasks;

import java.time.Duration;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.member.Frequency;

/** The pace of continuous features. */
final class Streams {

  /**
   * Fast enough for people and plans; a feature's frequency may only lower it. Stated assumption.
   */
  private static final double USUAL_HERTZ = 2;

  private Streams() {}

  static Duration period(FeatureType feature) {
    double hertz = Math.min(USUAL_HERTZ, feature.frequencyHertz().orElse(USUAL_HERTZ));
    return Duration.ofNanos(Math.round(1e9 / hertz));
  }

  /** The same for a caller who may wish for another pace, up to the feature's frequency. */
  static Duration period(FeatureType feature, CallParameters parameters) {
    double hertz = parameters.optionalNumber(Frequency.WANTED).orElse(USUAL_HERTZ);
    double highest = feature.frequencyHertz().orElse(USUAL_HERTZ);
    if (!(hertz > 0)) {
      throw new InvalidCallException(
          "The parameter %s is above 0 Hz, but is %s.".formatted(Frequency.WANTED, hertz));
    }
    return Duration.ofNanos(Math.round(1e9 / Math.min(hertz, highest)));
  }

  /** Runs the next round a period after the last one began, at once if it took longer. */
  static void next(FeatureContext context, Duration begun, Duration period, Runnable round) {
    Duration passed = context.clock().now().minus(begun);
    context.clock().schedule(period.minus(passed), context.device(), round);
  }
}
