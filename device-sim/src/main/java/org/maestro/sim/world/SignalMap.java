package org.maestro.sim.world;

import java.util.List;
import java.util.SplittableRandom;
import org.maestro.hal.Area;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.parameters.SignalData;

/**
 * The strength of a signal over the floor: one peak, at a place that the seed has chosen, and less
 * the farther from it (ADE, 4; A47). Immutable.
 */
public final class SignalMap {
  private static final double GRID_METRES = 0.5;

  /** Of chance that nothing else of the world depends on. */
  private static final long OWN_CHANCE = 0x51_6E_A1L;

  private final Point2 peak;
  private final SignalData data;

  private SignalMap(Point2 peak, SignalData data) {
    this.peak = peak;
    this.data = data;
  }

  /**
   * With its peak in one of the areas, away from their edges where they are large enough.
   *
   * @param areas without any it is at the origin
   */
  static SignalMap drawn(List<Area> areas, long seed, SignalData data) {
    List<Point2> all =
        areas.stream().flatMap(area -> area.outline().samples(GRID_METRES).stream()).toList();
    List<Point2> inner =
        all.stream()
            .filter(
                point ->
                    areas.stream()
                        .flatMap(area -> area.outline().edges().stream())
                        .allMatch(edge -> edge.distance(point) >= data.marginMetres()))
            .toList();
    List<Point2> places = inner.isEmpty() ? all : inner;
    Point2 peak =
        places.isEmpty()
            ? new Point2(0, 0)
            : places.get(new SplittableRandom(seed ^ OWN_CHANCE).nextInt(places.size()));
    return new SignalMap(peak, data);
  }

  /** Where it is strongest. */
  public Point2 peak() {
    return peak;
  }

  /** What a receiver at a place measures; with the usual peak 0 to 100. */
  public double strength(Point2 place) {
    return data.strength(place.distance(peak));
  }

  /** So near to the peak something can be transmitted; metres. */
  public double reachMetres() {
    return data.reachMetres();
  }
}
