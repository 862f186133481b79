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

  /**
   * The same picture, smaller: each pixel is that of the middle of what it stands for.
   *
   * @param widest pixels, at least 1; a picture that is no wider stays as it is
   */
  public Photo atMost(int widest) {
    if (width <= widest) {
      return this;
    }
    int rows = Math.max(1, (int) Math.round((double) height * widest / width));
    int[] smaller = new int[widest * rows];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < widest; column++) {
        smaller[row * widest + column] =
            at((2 * column + 1) * width / (2 * widest), (2 * row + 1) * height / (2 * rows));
      }
    }
    return new Photo(widest, rows, smaller);
  }
}
