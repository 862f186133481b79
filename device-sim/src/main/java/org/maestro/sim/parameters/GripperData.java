package org.maestro.sim.parameters;

/**
 * A jamming gripper: a bag of grains at the end of an arm.
 *
 * @param bagDiameter of the soft bag, a ball; metres; assumed, as the paper does not state it
 * @param vacuum pressure below the air's when the bag is evacuated; kilopascals; assumed, what a
 *     small pump reaches
 * @param pinch share of that with which the stiff bag presses upon the sides of what it wraps;
 *     assumed, which makes some tens of newtons
 * @param friction of the membrane on things; assumed for latex
 * @param lip so much of a wrapped side bears nothing, as the membrane bends away from it at its
 *     edge; metres; assumed
 * @param pressSeconds assumed
 * @param evacuateSeconds a jamming gripper's evacuation takes about a second (Brown et al. 2010)
 * @param inflateSeconds until positive pressure has softened the bag; assumed
 */
public record GripperData(
    double bagDiameter,
    double vacuum,
    double pinch,
    double friction,
    double lip,
    double pressSeconds,
    double evacuateSeconds,
    double inflateSeconds) {
  public static final GripperData USUAL = new GripperData(0.1, 75, 0.1, 1, 0.01, 0.5, 1, 0.5);

  /** The width of the widest thing that the bag gets around; metres. */
  public double opening() {
    return 2 * Math.sqrt(Math.max(0, bagDiameter * bagDiameter / 4 - lip * lip));
  }

  /** The same with a bag that just gets around things so wide; metres. */
  public GripperData opening(double width) {
    return width == opening()
        ? this
        : new GripperData(
            2 * Math.hypot(width / 2, lip),
            vacuum,
            pinch,
            friction,
            lip,
            pressSeconds,
            evacuateSeconds,
            inflateSeconds);
  }
}
