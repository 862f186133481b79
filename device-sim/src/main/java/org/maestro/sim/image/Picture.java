package org.maestro.sim.image;

import java.util.SplittableRandom;
import org.maestro.hal.Photo;
import org.maestro.hal.sight.Lens;
import org.maestro.hal.sight.Paint;

/**
 * The light that falls upon a camera's pixels at a moment, from which pictures are taken: each has
 * its own noise. The same stage, lens, exposure and seed give the same picture. Immutable.
 */
public final class Picture {

  private static final int CHANNELS = 3;
  private static final int END = 255;
  private static final int STEPS = 1 << 14;
  private static final int[] ENCODED = encoded();

  private final int width;
  private final int height;

  /** Shares of the end, red, green and blue of each pixel. */
  private final double[] shares;

  /** Standard deviations upon them. */
  private final double[] noise;

  private Picture(int width, int height, double[] shares, double[] noise) {
    this.width = width;
    this.height = height;
    this.shares = shares;
    this.noise = noise;
  }

  /** What a lens lets fall upon its pixels. */
  public static Picture of(Stage stage, Lens lens, Exposure exposure) {
    double[] light = new double[CHANNELS * lens.width() * lens.height()];
    Rays rays = new Rays(stage, lens.place());
    double sum = 0;
    for (int row = 0; row < lens.height(); row++) {
      for (int column = 0; column < lens.width(); column++) {
        Paint seen = rays.light(lens.direction(column, row));
        int at = CHANNELS * (row * lens.width() + column);
        light[at] = seen.red();
        light[at + 1] = seen.green();
        light[at + 2] = seen.blue();
        sum += seen.red() + seen.green() + seen.blue();
      }
    }
    double factor = exposure.factor(sum / light.length);
    double gain = exposure.gain(factor);
    double[] noise = new double[light.length];
    for (int i = 0; i < light.length; i++) {
      light[i] = Math.min(1, factor * light[i]);
      noise[i] = exposure.noise(light[i], gain);
    }
    return new Picture(lens.width(), lens.height(), light, noise);
  }

  /**
   * Takes one.
   *
   * @param seed of the noise
   */
  public Photo taken(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    int[] rgb = new int[width * height];
    for (int i = 0; i < shares.length; i++) {
      double noisy = shares[i] + noise[i] * random.nextGaussian();
      int step = (int) Math.round(STEPS * Math.max(0, Math.min(1, noisy)));
      rgb[i / CHANNELS] = rgb[i / CHANNELS] << Byte.SIZE | ENCODED[step];
    }
    return new Photo(width, height, rgb);
  }

  /** As sRGB, IEC 61966-2-1. */
  private static int[] encoded() {
    int[] encoded = new int[STEPS + 1];
    for (int step = 0; step <= STEPS; step++) {
      double share = (double) step / STEPS;
      double value = share <= 0.0031308 ? 12.92 * share : 1.055 * Math.pow(share, 1 / 2.4) - 0.055;
      encoded[step] = (int) Math.round(END * value);
    }
    return encoded;
  }
}
