package org.maestro.sim.parameters;

/** The exposure, noise and resolution of pictures. */
public record ImageData(
    @Quantity(
            meaning =
                "light in which, with the longest exposure, a wholly white thing is at the image's end",
            unit = "lux",
            source = "assumed: a floor in 72 lux just becomes a middle grey")
        double longestLux,
    @Quantity(
            meaning = "standard deviation of a channel of a pixel in the dark, share of its end",
            unit = "1",
            source = "assumed")
        double readNoise,
    @Quantity(meaning = "what comes on top of that at the end", unit = "1", source = "assumed")
        double shotNoise,
    @Quantity(
            meaning = "how finely the light upon the floor is measured for a picture",
            unit = "m",
            source = "a matter of computing")
        double gridMetres) {
  static final ImageData USUAL = new ImageData(170, 0.012, 0.02, 0.05);

  public ImageData {
    PhysicalParameters.positive("image.longestLux", longestLux);
    PhysicalParameters.positive("image.gridMetres", gridMetres);
  }
}
