package org.maestro.hal;

/**
 * A picture in colour.
 *
 * @param width pixels
 * @param height pixels
 * @param rgb row by row from the upper left corner, each pixel 0xRRGGBB in sRGB
 */
public record Photo(int width, int height, int[] rgb) {

  /**
   * @throws IllegalArgumentException when there are not as many pixels as width and height say
   */
  public Photo {
    if (rgb.length != width * height) {
      throw new IllegalArgumentException(
          "A picture of %d x %d pixels does not have %d.".formatted(width, height, rgb.length));
    }
    rgb = rgb.clone();
  }

  @Override
  public int[] rgb() {
    return rgb.clone();
  }

  /** One pixel, 0xRRGGBB. */
  public int at(int column, int row) {
    return rgb[row * width + column];
  }
}
