package org.maestro.hal;

/** A sensor of persons in the zone in which it stands. It tells what changed last. */
public interface PresenceSensor {

  boolean isSomebodyThere();
}
