package org.maestro.console.references;

import java.util.Locale;

/** The part that a component has in the whole, as DIARC names them (ADE, 3.3; A39). */
enum Faculty {
  /** Moods that scripts show. */
  AFFECT,
  /** Goals, plans, scripts, and what is known. */
  COGNITION,
  /** Whether the others live and do what they are to do, and why what was done was done. */
  REFLECTION,
  /** Cameras, sensors, and what is concluded from what they tell. */
  PERCEPTION,
  /** Getting from place to place. */
  NAVIGATION,
  /** All else that changes something. */
  ACTION,
  /** What people say, and what is said to them. */
  LANGUAGE;

  String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
