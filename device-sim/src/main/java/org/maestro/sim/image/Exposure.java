package org.maestro.sim.image;

/**
 * A camera's exposure, gain and noise, by which light becomes a picture. The camera exposes so that
 * the mean of the picture becomes a middle grey: first by its exposure, then by its gain, as far as
 * both go. In little light noise shows, in too much pictures are white.
 *
 * @param saturationLux with the shortest exposure, a wholly white surface in so much light is at
 *     the picture's end
 * @param longestLux the same with the longest exposure and no gain
 * @param mostGain what it can multiply with beyond that, from 1 on
 * @param readNoise of each channel in each pixel without gain, share of the end; standard deviation
 * @param shotNoise what comes on top in a pixel at the end; it falls with the root of the light
 */
public record Exposure(
    double saturationLux, double longestLux, double mostGain, double readNoise, double shotNoise) {

  /** Share of the end to which the mean is exposed: what a grey card throws back. */
  private static final double MIDDLE_GREY = 0.18;

  /**
   * What light is multiplied with.
   *
   * @param mean light from all pixels: share thrown back times lux
   */
  double factor(double mean) {
    double least = 1 / saturationLux;
    double most = mostGain / longestLux;
    return Math.max(least, Math.min(most, MIDDLE_GREY / Math.max(mean, 1e-9)));
  }

  /** What of the factor the exposure does not bring; 1 when it brings all. */
  double gain(double factor) {
    return Math.max(1, factor * longestLux);
  }

  /**
   * Standard deviation of the noise upon a share of the end. With gain the end is reached by fewer
   * electrons, of which each counts for more.
   */
  double noise(double share, double gain) {
    double read = gain * readNoise;
    return Math.sqrt(read * read + gain * shotNoise * shotNoise * share);
  }
}
