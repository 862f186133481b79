package org.maestro.sim.image;

/** Shares of red, green and blue light, 0 to 1, that a surface throws back. */
public record Colour(double red, double green, double blue) {

  /** The same colour, darker or lighter. */
  Colour times(double factor) {
    return new Colour(red * factor, green * factor, blue * factor);
  }
}
