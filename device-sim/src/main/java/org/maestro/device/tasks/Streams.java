package org.maestro.device.tasks;

import java.time.Duration;
import org.maestro.ontology.vocabulary.FeatureType;

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

  /** Runs the next round a period after the last one began, at once if it took longer. */
  static void next(FeatureContext context, Duration begun, Duration period, Runnable round) {
    Duration passed = context.clock().now().minus(begun);
    context.clock().schedule(period.minus(passed), context.device(), round);
  }
}
