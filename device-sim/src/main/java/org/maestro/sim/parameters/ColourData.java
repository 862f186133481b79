package org.maestro.sim.parameters;

/**
 * The saturation of colours in an image, and the distance at which one is taken for another. A
 * channel of the image stands still where the light that a thing throws back in it exceeds {@code
 * saturationLux}.
 */
public record ColourData(
    @Quantity(
            meaning = "light in which a wholly white thing is at the image's end",
            unit = "lux",
            source = "assumed: that from which colours wash out")
        double saturationLux,
    @Quantity(
            meaning =
                "distance in chromaticity, shares of red and green, at which one colour is taken for another in six frames of ten",
            unit = "1",
            source = "assumed")
        double tolerance) {
  static final ColourData USUAL = new ColourData(2000, 0.1);

  public ColourData {
    PhysicalParameters.positive("colour.saturationLux", saturationLux);
    PhysicalParameters.positive("colour.tolerance", tolerance);
  }
}
