package org.maestro.experiment.running;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.world.PathPoint;

/** A robot's places at even times: between two corners of its path it drove evenly. */
public record Trail(Duration step, List<Point2> places) {
  public Trail {
    places = List.copyOf(places);
  }

  /**
   * @param path corners with their times, in order
   * @param start where it stood before the first
   */
  public static Trail sampled(
      List<PathPoint> path, Point2 start, Duration begin, Duration end, Duration step) {
    List<Point2> places = new ArrayList<>();
    Point2 at = start;
    int next = 0;
    for (Duration now = begin; now.compareTo(end) <= 0; now = now.plus(step)) {
      while (next < path.size() && path.get(next).at().compareTo(now) <= 0) {
        at = path.get(next).point();
        next++;
      }
      places.add(next == 0 || next == path.size() ? at : between(path, next, now));
    }
    return new Trail(step, places);
  }

  private static Point2 between(List<PathPoint> path, int next, Duration now) {
    PathPoint from = path.get(next - 1);
    PathPoint to = path.get(next);
    double whole = to.at().minus(from.at()).toNanos();
    double share = whole <= 0 ? 1 : now.minus(from.at()).toNanos() / whole;
    return new Point2(
        from.point().x() + share * (to.point().x() - from.point().x()),
        from.point().y() + share * (to.point().y() - from.point().y()));
  }

  /**
   * Metres of it that lie farther away than that from every place of another.
   *
   * @param stride every so many of the samples is looked at
   */
  public double strayFrom(Trail other, double metres, int stride) {
    double stray = 0;
    for (int i = stride; i < places.size(); i += stride) {
      Point2 place = places.get(i);
      double driven = places.get(i - stride).distance(place);
      if (driven > 0 && !other.passes(place, metres, stride)) {
        stray += driven;
      }
    }
    return stray;
  }

  private boolean passes(Point2 place, double metres, int stride) {
    for (int i = 0; i < places.size(); i += stride) {
      if (places.get(i).distance(place) <= metres) {
        return true;
      }
    }
    return false;
  }

  /** Metres driven. */
  public double length() {
    double length = 0;
    for (int i = 1; i < places.size(); i++) {
      length += places.get(i - 1).distance(places.get(i));
    }
    return length;
  }
}
