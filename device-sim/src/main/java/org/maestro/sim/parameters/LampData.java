package org.maestro.sim.parameters;

import java.util.List;

/**
 * The transition time of a dimmable lamp, and its shades of white.
 *
 * @param transitionSeconds Hue's usual transition time is 400 ms; the light jumps at its end
 *     (assumed)
 * @param whiteKelvin the white it starts with; assumed
 * @param whites the shades that the spots have; paper 4.1: four, these assumed from what Hue calls
 *     relax, read, concentrate and energize, within its 2,200 to 6,500 K
 */
public record LampData(double transitionSeconds, int whiteKelvin, List<Integer> whites) {
  static final LampData HUE = new LampData(0.4, 2700, List.of(2200, 2700, 4000, 6500));

  public LampData {
    whites = List.copyOf(whites);
  }
}
