package org.maestro.ontology.floor;

import org.maestro.sl.SlPrinter;

/**
 * A position and orientation in space: metres, and degrees about the vertical axis (yaw, from x
 * towards y), upwards from the horizontal (pitch) and about its own axis (roll). A pose of ceiling
 * cameras and lamps that says only where they are looks straight down: see {@link #parse}.
 */
public record Pose(double x, double y, double z, double yaw, double pitch, double roll) {

  private static final double DOWN = -90;

  /**
   * Reads {@code "x y z"}, which looks straight down, or {@code "x y z yaw pitch roll"}.
   *
   * @throws IllegalArgumentException when the text is anything else
   */
  public static Pose parse(String text) {
    double[] n = numbers(text);
    return switch (n.length) {
      case 3 -> new Pose(n[0], n[1], n[2], 0, DOWN, 0);
      case 6 -> new Pose(n[0], n[1], n[2], n[3], n[4], n[5]);
      default ->
          throw new IllegalArgumentException(
              "A pose is \"x y z\" or \"x y z yaw pitch roll\", but here is \"" + text + "\".");
    };
  }

  public Point2 floor() {
    return new Point2(x, y);
  }

  /** The angle between the axis of view and the way to a point; degrees from 0 to 180. */
  public double angleTo(double pointX, double pointY, double pointZ) {
    double dx = pointX - x;
    double dy = pointY - y;
    double dz = pointZ - z;
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (length == 0) {
      return 0;
    }
    double horizontal = Math.cos(Math.toRadians(pitch));
    double along =
        dx * horizontal * Math.cos(Math.toRadians(yaw))
            + dy * horizontal * Math.sin(Math.toRadians(yaw))
            + dz * Math.sin(Math.toRadians(pitch));
    return Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, along / length))));
  }

  /** The text that {@link #parse} reads; without angles when it looks straight down. */
  public String text() {
    String position = print(x) + " " + print(y) + " " + print(z);
    return yaw == 0 && pitch == DOWN && roll == 0
        ? position
        : position + " " + print(yaw) + " " + print(pitch) + " " + print(roll);
  }

  private static String print(double number) {
    return SlPrinter.print(number);
  }

  /**
   * Reads numbers with blanks between.
   *
   * @throws IllegalArgumentException when the text is anything else, or a number is not finite
   */
  public static double[] numbers(String text) {
    String[] words = text.strip().split("\\s+");
    double[] numbers = new double[words.length];
    for (int i = 0; i < words.length; i++) {
      try {
        numbers[i] = Double.parseDouble(words[i]);
      } catch (NumberFormatException e) {
        throw new IllegalArgumentException(
            "Coordinates are numbers with blanks between, but here is \"" + text.strip() + "\".",
            e);
      }
      if (!Double.isFinite(numbers[i])) {
        throw new IllegalArgumentException(
            "A coordinate is a finite number, not " + words[i] + ".");
      }
    }
    return numbers;
  }
}
