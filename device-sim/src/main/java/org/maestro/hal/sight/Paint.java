package org.maestro.hal.sight;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Pattern;

/**
 * The colour of a surface: the shares of red, green and blue light, 0 to 1, that it throws back.
 */
public record Paint(double red, double green, double blue) {

  /** Of what nobody says the colour of. */
  public static final Paint GREY = new Paint(0.4, 0.4, 0.4);

  private static final int VALUES = 256;
  private static final double[] LINEAR = decoded();
  private static final Pattern HEXADECIMAL = Pattern.compile("#[0-9a-fA-F]{6}");
  private static final Map<String, Paint> NAMED = named();

  /** Paints and plastics of these names; assumed. */
  private static Map<String, Paint> named() {
    Map<String, Paint> paints = new TreeMap<>();
    paints.put("red", new Paint(0.62, 0.05, 0.05));
    paints.put("green", new Paint(0.06, 0.42, 0.10));
    paints.put("blue", new Paint(0.05, 0.12, 0.50));
    paints.put("yellow", new Paint(0.75, 0.60, 0.04));
    paints.put("orange", new Paint(0.78, 0.24, 0.03));
    paints.put("purple", new Paint(0.28, 0.06, 0.40));
    paints.put("pink", new Paint(0.80, 0.35, 0.45));
    paints.put("brown", new Paint(0.22, 0.10, 0.04));
    paints.put("turquoise", new Paint(0.05, 0.45, 0.42));
    paints.put("white", new Paint(0.85, 0.85, 0.85));
    paints.put("grey", GREY);
    paints.put("black", new Paint(0.04, 0.04, 0.04));
    return Map.copyOf(paints);
  }

  /** By a name such as {@code red}, or as {@code #a03020}; empty when it is neither. */
  public static Optional<Paint> parse(String text) {
    if (HEXADECIMAL.matcher(text).matches()) {
      int rgb = Integer.parseInt(text.substring(1), 16);
      return Optional.of(ofPixel(rgb));
    }
    return Optional.ofNullable(NAMED.get(text.strip().toLowerCase(Locale.ROOT)));
  }

  /** What a pixel shows: shares of the light that is at its end. */
  static Paint ofPixel(int rgb) {
    return new Paint(linear(rgb >> 16), linear(rgb >> 8), linear(rgb));
  }

  private static double linear(int channel) {
    return LINEAR[channel & 0xff];
  }

  /** Of the values of an sRGB channel, IEC 61966-2-1. */
  private static double[] decoded() {
    double[] linear = new double[VALUES];
    for (int channel = 0; channel < VALUES; channel++) {
      double value = channel / (VALUES - 1.0);
      linear[channel] = value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4);
    }
    return linear;
  }

  /**
   * What an image shows of it in so much light: no channel exceeds its end.
   *
   * @param saturationLux light in which a wholly white thing is at the image's end
   */
  public Paint seenIn(double lux, double saturationLux) {
    double share = lux / saturationLux;
    return new Paint(
        Math.min(1, red * share), Math.min(1, green * share), Math.min(1, blue * share));
  }

  /** The same colour, darker or lighter. */
  public Paint times(double factor) {
    return new Paint(red * factor, green * factor, blue * factor);
  }

  /** Distance in the shares of red and of green: colours apart from how bright they are. */
  public double distance(Paint other) {
    double sum = red + green + blue;
    double otherSum = other.red + other.green + other.blue;
    return sum == 0 || otherSum == 0
        ? 1
        : Math.hypot(red / sum - other.red / otherSum, green / sum - other.green / otherSum);
  }
}
