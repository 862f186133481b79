package org.maestro.sim.parameters;

/**
 * A signal with one peak, and what a robot does with it. The paper tells no number of its field
 * server (ADE, 4): all are assumed.
 */
public record SignalData(
    @Quantity(
            meaning = "strength at the peak",
            unit = "1",
            source = "assumed; the paper tells no number of its field server (ADE, 4)")
        double peak,
    @Quantity(
            meaning =
                "distance from the peak at which half of it is left; it falls as 1 / (1 + (d / halfMetres)²)",
            unit = "m",
            source = "assumed")
        double halfMetres,
    @Quantity(
            meaning = "least distance of the peak from the edge of the areas that are mapped",
            unit = "m",
            source = "assumed")
        double marginMetres,
    @Quantity(
            meaning = "least strength with which something can be transmitted",
            unit = "1",
            source = "assumed")
        double needed,
    @Quantity(meaning = "time of a reading", unit = "s", source = "assumed") double readSeconds,
    @Quantity(meaning = "time of a transmission", unit = "s", source = "assumed")
        double transmitSeconds) {
  static final SignalData USUAL = new SignalData(100, 5, 2, 80, 1, 3);

  public SignalData {
    PhysicalParameters.positive("signal.peak", peak);
    PhysicalParameters.positive("signal.halfMetres", halfMetres);
  }

  /**
   * The strength at some distance from the peak.
   *
   * @param metres from the peak
   */
  public double strength(double metres) {
    double halves = metres / halfMetres;
    return peak / (1 + halves * halves);
  }

  /** So near to the peak something can be transmitted; metres, 0 where it can be nowhere. */
  public double reachMetres() {
    return needed <= 0
        ? Double.POSITIVE_INFINITY
        : halfMetres * Math.sqrt(Math.max(0, peak / needed - 1));
  }
}
