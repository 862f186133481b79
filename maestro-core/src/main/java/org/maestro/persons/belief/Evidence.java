package org.maestro.persons.belief;

import java.util.Optional;

/**
 * Something that was noticed, or was not though it might have been.
 *
 * @param person who; empty: somebody, nobody knows who
 * @param zone where
 * @param said whether it was noticed
 * @param hitRate how often it is said where it is so, above the false rate
 * @param falseRate how often it is said where it is not so, more than 0 and less than 1
 */
public record Evidence(
    Optional<String> person, String zone, boolean said, double hitRate, double falseRate) {
  public Evidence {
    if (!(falseRate > 0 && falseRate <= hitRate && hitRate < 1)) {
      throw new IllegalArgumentException(
          "The rates of evidence lie between 0 and 1, the hit rate above the false rate: %s and %s"
              .formatted(hitRate, falseRate));
    }
  }

  /**
   * The same, which its source is only so sure of; or the part of the zone of which it speaks.
   *
   * @param share 0: it says nothing, to 1
   */
  public Evidence weakened(double share) {
    double kept = Math.max(0, Math.min(1, share));
    return new Evidence(person, zone, said, falseRate + kept * (hitRate - falseRate), falseRate);
  }

  /** How likely it is where it is so. */
  double likelihoodWhereSo() {
    return said ? hitRate : 1 - hitRate;
  }

  /** How likely it is where it is not so. */
  double likelihoodElsewhere() {
    return said ? falseRate : 1 - falseRate;
  }
}
