package org.maestro.sim.parameters;

/** The range finder of a robot, and for how long it trusts what that showed. */
public record ScannerData(
    @Quantity(
            meaning = "how far it sees, to all sides",
            unit = "m",
            source =
                "URG-04LX data sheet: 5.6, over 240 degrees; that nothing is behind it is assumed")
        double range,
    @Quantity(
            meaning =
                "for how long a robot takes a body that moves to be where it saw it, once it is out"
                    + " of sight",
            unit = "s",
            source = "assumed")
        double memorySeconds,
    @Quantity(
            meaning =
                "standard deviation of the place that a robot whose wheels slip finds by matching"
                    + " what it sees with its plan, on each axis",
            unit = "m",
            source = "assumed")
        double matchError,
    @Quantity(
            meaning = "the same of the direction in which it looks",
            unit = "degrees",
            source = "assumed")
        double matchDegrees,
    @Quantity(
            meaning = "share of its error that it so makes good with each command to the wheels",
            unit = "1",
            source = "assumed")
        double matchShare) {
  static final ScannerData URG = new ScannerData(5.6, 10, 0.03, 1, 0.2);

  public ScannerData {
    PhysicalParameters.positive("scanner.range", range);
    PhysicalParameters.share("scanner.matchShare", matchShare);
  }
}
