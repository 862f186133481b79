package org.maestro.sim.parameters;

/**
 * The exposure, noise and resolution of pictures.
 *
 * @param longestLux with the longest exposure, a wholly white thing in so much light is at the
 *     image's end; assumed: a floor in 72 lux just becomes a middle grey
 * @param readNoise of a channel of a pixel, share of its end, standard deviation; assumed
 * @param shotNoise what comes on top at the end; assumed
 * @param gridMetres how finely the light upon the floor is measured for a picture
 */
public record ImageData(double longestLux, double readNoise, double shotNoise, double gridMetres) {
  static final ImageData USUAL = new ImageData(170, 0.012, 0.02, 0.05);

  public ImageData {
    PhysicalParameters.positive("image.longestLux", longestLux);
    PhysicalParameters.positive("image.gridMetres", gridMetres);
  }
}
