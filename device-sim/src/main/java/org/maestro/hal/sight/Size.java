package org.maestro.hal.sight;

import java.util.Optional;

/** Length, width and height of the box around a thing; metres, more than 0. */
public record Size(double length, double width, double height) {
  private static final int LENGTHS = 3;

  /** Three lengths, such as {@code 0.08 0.08 0.1}; empty when it is something else. */
  public static Optional<Size> parse(String text) {
    String[] words = text.strip().split("\\s+");
    if (words.length != LENGTHS) {
      return Optional.empty();
    }
    try {
      Size size =
          new Size(
              Double.parseDouble(words[0]),
              Double.parseDouble(words[1]),
              Double.parseDouble(words[2]));
      return size.length() > 0 && size.width() > 0 && size.height() > 0
          ? Optional.of(size)
          : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** The mean area that is seen of it from all sides; square metres. */
  public double outline() {
    // of a convex body a quarter of its surface
    return (length * width + width * height + height * length) / 2;
  }
}
