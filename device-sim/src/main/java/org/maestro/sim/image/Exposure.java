package org.maestro.sim.image;

/**
 * A camera's exposure and noise, by which light becomes a picture. The camera exposes so that the
 * mean of the picture becomes a middle grey, as far as its shortest and longest exposure allow: in
 * little light pictures are dark and noise shows, in too much they are white.
 *
 * @param saturationLux with the shortest exposure, a wholly white surface in so much light is at
 *     the picture's end
 * @param darkLux with the longest exposure, a grey surface in so much light becomes the middle grey
 * @param readNoise of each channel in each pixel, share of the end; standard deviation
 * @param shotNoise what comes on top in a pixel at the end; it falls with the root of the light
 */
public record Exposure(double saturationLux, double darkLux, double readNoise, double shotNoise) {

  /** Share of the end to which the mean is exposed: what a grey card throws back. */
  private static final double MIDDLE_GREY = 0.18;

  /**
   * What light is multiplied with.
   *
   * @param mean light from all pixels: share thrown back times lux
   */
  double factor(double mean) {
    double shortest = 1 / saturationLux;
    double longest = 1 / darkLux;
    return Math.max(shortest, Math.min(longest, MIDDLE_GREY / Math.max(mean, 1e-9)));
  }

  /** Standard deviation of the noise upon a share of the end. */
  double noise(double share) {
    return Math.sqrt(readNoise * readNoise + shotNoise * shotNoise * share);
  }
}
