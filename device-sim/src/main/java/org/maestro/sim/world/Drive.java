package org.maestro.sim.world;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** A drive at constant speed along straight pieces, begun at a moment. */
public record Drive(Duration begun, Point2 from, List<Point2> way, double speed) {

  private static final double NANOS = 1e9;

  public Drive {
    way = List.copyOf(way);
  }

  public Duration duration() {
    return duration(length());
  }

  double length() {
    double length = 0;
    for (Segment piece : pieces()) {
      length += piece.length();
    }
    return length;
  }

  public Point2 positionAt(Duration now) {
    double left = Math.max(0, now.minus(begun).toNanos() / NANOS * speed);
    for (Segment piece : pieces()) {
      if (left < piece.length()) {
        return piece.at(left / piece.length());
      }
      left -= piece.length();
    }
    return way.isEmpty() ? from : way.get(way.size() - 1);
  }

  /** Where it passed until now, with times: begin, corners, and the present place. */
  List<PathPoint> pathUntil(Duration now) {
    List<PathPoint> path = new ArrayList<>();
    path.add(new PathPoint(begun, from));
    double length = 0;
    for (Segment piece : pieces()) {
      length += piece.length();
      Duration passed = begun.plus(duration(length));
      if (passed.compareTo(now) < 0) {
        path.add(new PathPoint(passed, piece.to()));
      }
    }
    path.add(new PathPoint(now, positionAt(now)));
    return path;
  }

  /** The corners still to come. */
  public List<Point2> wayAhead(Duration now) {
    double passed = Math.max(0, now.minus(begun).toNanos() / NANOS * speed);
    List<Point2> left = new ArrayList<>();
    for (Segment piece : pieces()) {
      passed -= piece.length();
      if (passed < 0) {
        left.add(piece.to());
      }
    }
    return left;
  }

  /** What lies ahead for so long, from the present place. */
  public List<Segment> ahead(Duration now, double seconds) {
    List<Segment> ahead = new ArrayList<>();
    double skip = Math.max(0, now.minus(begun).toNanos() / NANOS * speed);
    double left = seconds * speed;
    for (Segment piece : pieces()) {
      double length = piece.length();
      if (skip >= length) {
        skip -= length;
        continue;
      }
      double to = Math.min(length, skip + left);
      ahead.add(new Segment(piece.at(skip / length), piece.at(to / length)));
      left -= to - skip;
      skip = 0;
      if (left <= 0) {
        break;
      }
    }
    return ahead;
  }

  private Duration duration(double length) {
    return Duration.ofNanos((long) Math.ceil(length / speed * NANOS));
  }

  private List<Segment> pieces() {
    List<Segment> pieces = new ArrayList<>();
    Point2 at = from;
    for (Point2 next : way) {
      pieces.add(new Segment(at, next));
      at = next;
    }
    return pieces;
  }
}
