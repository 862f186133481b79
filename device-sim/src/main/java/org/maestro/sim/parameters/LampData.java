package org.maestro.sim.parameters;

import java.util.List;

/** The transition time of a dimmable lamp, and its shades of white. */
public record LampData(
    @Quantity(
            meaning = "time in which it takes on another level",
            unit = "s",
            source = "Hue: usually 400 ms; that the light jumps at its end is assumed")
        double transitionSeconds,
    @Quantity(meaning = "the white with which it starts", unit = "K", source = "assumed")
        int whiteKelvin,
    @Quantity(
            meaning = "the shades of white that the spots have",
            unit = "K",
            source =
                "paper 4.1: four; these assumed from what Hue calls relax, read, concentrate and energize, within its 2,200 to 6,500 K")
        List<Integer> whites) {
  static final LampData HUE = new LampData(0.4, 2700, List.of(2200, 2700, 4000, 6500));

  public LampData {
    whites = List.copyOf(whites);
  }
}
