package org.maestro.sim.parameters;

/**
 * A signal with one peak, and what a robot does with it. The paper tells no number of its field
 * server (ADE, 4): all are assumed.
 *
 * @param peak strength at the peak
 * @param halfMetres so far from the peak half of it is left; it falls as 1 / (1 + (d /
 *     halfMetres)²)
 * @param marginMetres the peak is no nearer than this to the edge of the areas that are mapped
 * @param needed the least strength with which something can be transmitted
 * @param readSeconds what a reading takes
 * @param transmitSeconds what a transmission takes
 */
public record SignalData(
    double peak,
    double halfMetres,
    double marginMetres,
    double needed,
    double readSeconds,
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
