package org.maestro.sim.image;

import java.util.Random;
import org.maestro.hal.Photo;

/** Takes pictures: the same stage, lens, exposure and seed give the same picture. */
public final class Picture {

  private static final int CHANNELS = 3;
  private static final int END = 255;

  private Picture() {}

  /**
   * @param seed of the noise
   */
  public static Photo of(Stage stage, Lens lens, Exposure exposure, long seed) {
    int pixels = lens.width() * lens.height();
    double[] light = new double[CHANNELS * pixels];
    Rays rays = new Rays(stage, lens.place());
    double sum = 0;
    for (int row = 0; row < lens.height(); row++) {
      for (int column = 0; column < lens.width(); column++) {
        Colour seen = rays.light(lens.direction(column, row));
        int at = CHANNELS * (row * lens.width() + column);
        light[at] = seen.red();
        light[at + 1] = seen.green();
        light[at + 2] = seen.blue();
        sum += seen.red() + seen.green() + seen.blue();
      }
    }
    double factor = exposure.factor(sum / light.length);
    Random random = new Random(seed);
    int[] rgb = new int[pixels];
    for (int pixel = 0; pixel < pixels; pixel++) {
      for (int channel = 0; channel < CHANNELS; channel++) {
        double share = Math.min(1, factor * light[CHANNELS * pixel + channel]);
        double noisy = share + exposure.noise(share) * random.nextGaussian();
        rgb[pixel] = rgb[pixel] << 8 | encoded(noisy);
      }
    }
    return new Photo(lens.width(), lens.height(), rgb);
  }

  /** As sRGB, IEC 61966-2-1. */
  private static int encoded(double share) {
    double clipped = Math.max(0, Math.min(1, share));
    double value =
        clipped <= 0.0031308 ? 12.92 * clipped : 1.055 * Math.pow(clipped, 1 / 2.4) - 0.055;
    return (int) Math.round(END * value);
  }
}
