package org.maestro.sim.parameters;

/** A jamming gripper: a bag of grains at the end of an arm. */
public record GripperData(
    @Quantity(
            meaning = "diameter of the soft bag, a ball",
            unit = "m",
            source = "assumed, as the paper does not state it")
        double bagDiameter,
    @Quantity(
            meaning = "pressure below the air's when the bag is evacuated",
            unit = "kPa",
            source = "assumed: what a small pump reaches")
        double vacuum,
    @Quantity(
            meaning =
                "share of that with which the stiff bag presses upon the sides of what it wraps",
            unit = "1",
            source = "assumed: it makes some tens of newtons")
        double pinch,
    @Quantity(
            meaning = "friction of the membrane on things",
            unit = "1",
            source = "assumed for latex")
        double friction,
    @Quantity(
            meaning =
                "how much of a wrapped side bears nothing, as the membrane bends away from it at its edge",
            unit = "m",
            source = "assumed")
        double lip,
    @Quantity(meaning = "time for pressing the bag upon a thing", unit = "s", source = "assumed")
        double pressSeconds,
    @Quantity(
            meaning = "time for evacuating it",
            unit = "s",
            source = "Brown et al. 2010: about a second")
        double evacuateSeconds,
    @Quantity(
            meaning = "time until positive pressure has softened the bag",
            unit = "s",
            source = "assumed")
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
