package org.maestro.sl;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A point in the frame of a home, by its coordinates. In MAESTRO-SL {@code (at 3.2 1.5 0.8)} stands
 * for its name, {@code at_3.2_1.5_0.8}, wherever a term may stand (Three-layered architecture, 1;
 * M5).
 *
 * @param x metres
 * @param y metres
 * @param z metres above the floor
 */
public record Point(double x, double y, double z) {
  /** The word with which a point begins. */
  static final String WORD = "at";

  private static final String NUMBER = "_(-?\\d[-+.\\dE]*)";
  private static final Pattern NAME = Pattern.compile(WORD + NUMBER + NUMBER + NUMBER);

  public Point {
    // Without this, minus nothing would be another point than nothing.
    x += 0.0;
    y += 0.0;
    z += 0.0;
  }

  /** The name that stands for the point: that of equal coordinates is the same. */
  public String name() {
    return String.join("_", WORD, SlPrinter.print(x), SlPrinter.print(y), SlPrinter.print(z));
  }

  /** Its coordinates as the position of a thing has them, such as {@code 3.2 1.5 0.8}. */
  public String coordinates() {
    return String.join(" ", SlPrinter.print(x), SlPrinter.print(y), SlPrinter.print(z));
  }

  /** The point that a name stands for; empty when it is another name. */
  public static Optional<Point> named(String name) {
    if (!name.startsWith(WORD)) {
      return Optional.empty();
    }
    Matcher numbers = NAME.matcher(name);
    if (!numbers.matches()) {
      return Optional.empty();
    }
    try {
      Point point = new Point(number(numbers, 1), number(numbers, 2), number(numbers, 3));
      return Optional.of(point).filter(same -> same.name().equals(name));
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  private static double number(Matcher numbers, int group) {
    return Double.parseDouble(numbers.group(group));
  }
}
