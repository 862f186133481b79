package org.maestro.hal;

import java.util.Map;

/**
 * A sensor that tells persons apart, by their looks or by what they carry, in the zone in which it
 * stands. It tells what changed last.
 */
public interface PersonRecognition {

  /** Whether each person is there, by name; of whom it cannot tell now nothing is said. */
  Map<String, Boolean> persons();
}
