package org.maestro.ontology.home;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;

/**
 * A kind of fact from which one concludes who is where (ADE, 1: multi-modal person tracking; A2).
 *
 * @param of the class of devices that tell it; of what no device tells of itself, its predicate
 * @param fact over {@code ?self}, {@code ?person} and {@code ?zone}; without {@code ?person} it
 *     says that somebody is there
 * @param hitRate how often it is told where it is so, between 0 and 1
 * @param falseRate how often it is told where it is not so, between 0 and 1
 * @param countsAgainAfter after how long what a device goes on to say is as good as another cue;
 *     empty: it counts each time that it is said
 * @param spoken whether the person was heard to speak there
 */
public record PersonCue(
    String of,
    Formula.Atom fact,
    double hitRate,
    double falseRate,
    Optional<Duration> countsAgainAfter,
    boolean spoken) {
  /** The variable of the person. */
  public static final String PERSON = "person";

  /** The variable of the zone. */
  public static final String ZONE = "zone";

  /** Whether devices tell it of what they notice. */
  public boolean isOfDevices() {
    return has(Self.NAME);
  }

  /** Whether it tells who is there. */
  public boolean namesThePerson() {
    return has(PERSON);
  }

  /** Whether it tells where, and not only that somebody is in the device's zone. */
  public boolean namesTheZone() {
    return has(ZONE);
  }

  private boolean has(String variable) {
    return FreeVariables.of(fact).contains(variable);
  }
}
