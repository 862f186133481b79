package org.maestro.hal;

import java.util.List;
import java.util.OptionalInt;

/** A dimmable lamp with white shades (Three-layered architecture, 4.1; M82). */
public interface DimmableLamp {

  /**
   * @param level share of full light, 0 to 1
   * @param whiteKelvin colour temperature, or empty to keep it
   */
  void set(double level, OptionalInt whiteKelvin, Completion completion);

  /** The level that the lamp believes it has. */
  double level();

  int whiteKelvin();

  /** The shades of white that it has; kelvin. Setting another one fails. */
  List<Integer> whites();
}
