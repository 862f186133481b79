package org.maestro.sim.world;

import java.util.Locale;
import java.util.Optional;
import org.maestro.hal.sight.Size;
import org.maestro.sim.parameters.GripperData;

/**
 * The grip of a bag that wraps an upright thing and holds it by its sides. Pressed on until its
 * middle is level with the thing's top, a ball reaches down the two sides that are nearest to each
 * other as far as its surface lies below its middle there. What holds are pinch and friction;
 * suction and interlocking (Brown et al. 2010), and the other two sides, would add to it and are
 * not counted.
 */
public record Wrap(GripperData bag, Size size) {

  private static final double NEWTONS_PER_KILOGRAM = 9.81;
  private static final double PASCALS_PER_KILOPASCAL = 1000;
  private static final double CENTIMETRES = 100;

  /** Below its middle, where the nearest sides are; metres, 0 when they are beyond it. */
  private double reach() {
    double radius = bag.bagDiameter() / 2;
    double side = Math.min(size.length(), size.width()) / 2;
    return side >= radius ? 0 : Math.sqrt(radius * radius - side * side);
  }

  /** What it bears; newtons. */
  public double force() {
    double breadth = Math.min(Math.max(size.length(), size.width()), 2 * reach());
    double depth = Math.max(0, Math.min(size.height(), reach()) - bag.lip());
    double stress = bag.pinch() * bag.vacuum() * PASCALS_PER_KILOPASCAL;
    return bag.friction() * stress * 2 * breadth * depth;
  }

  /** Why a thing so heavy is not held; empty when it is. */
  public Optional<String> failure(double kilograms) {
    double weight = kilograms * NEWTONS_PER_KILOGRAM;
    if (reach() <= bag.lip()) {
      return Optional.of(
          said("it is too large for a bag of %.0f cm", CENTIMETRES * bag.bagDiameter()));
    } else if (size.height() <= bag.lip()) {
      return Optional.of("it is too flat for the bag to get around it");
    } else if (force() < weight) {
      return Optional.of(
          said("it slips out of the bag, which bears %.1f N of %.1f N", force(), weight));
    }
    return Optional.empty();
  }

  private static String said(String sentence, Object... numbers) {
    return String.format(Locale.ROOT, sentence, numbers);
  }
}
