package org.maestro.ontology.floor;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The walls of a home, made from its rooms' outlines and from openings such as those of open doors.
 * Immutable.
 */
public final class FloorPlan {

  /** Of a box: its least and greatest x, its least and greatest y. */
  private static final int SIDES = 4;

  private final List<Segment> walls;

  /** The boxes around the walls one after the other: nearly all are told apart by them. */
  private final double[] boxes;

  /**
   * @param openings lie on the outlines' edges and take away their part of the walls
   */
  public FloorPlan(List<Polygon> rooms, List<Segment> openings) {
    List<Segment> pieces = new ArrayList<>();
    for (Polygon room : rooms) {
      for (Segment edge : room.edges()) {
        pieces.addAll(without(edge, openings));
      }
    }
    this.walls = List.copyOf(pieces);
    this.boxes = new double[SIDES * walls.size()];
    for (int i = 0; i < walls.size(); i++) {
      Point2 from = walls.get(i).from();
      Point2 to = walls.get(i).to();
      boxes[SIDES * i] = Math.min(from.x(), to.x()) - Segment.TOLERANCE;
      boxes[SIDES * i + 1] = Math.max(from.x(), to.x()) + Segment.TOLERANCE;
      boxes[SIDES * i + 2] = Math.min(from.y(), to.y()) - Segment.TOLERANCE;
      boxes[SIDES * i + 3] = Math.max(from.y(), to.y()) + Segment.TOLERANCE;
    }
  }

  /** The edges without the openings. A wall between two rooms appears once per room. */
  public List<Segment> walls() {
    return walls;
  }

  /** Whether a wall stands between both points. */
  public boolean isBlocked(Point2 from, Point2 to) {
    Segment way = new Segment(from, to);
    double leastX = Math.min(from.x(), to.x());
    double mostX = Math.max(from.x(), to.x());
    double leastY = Math.min(from.y(), to.y());
    double mostY = Math.max(from.y(), to.y());
    for (int box = 0; box < boxes.length; box += SIDES) {
      if (boxes[box] <= mostX
          && boxes[box + 1] >= leastX
          && boxes[box + 2] <= mostY
          && boxes[box + 3] >= leastY
          && way.intersects(walls.get(box / SIDES))) {
        return true;
      }
    }
    return false;
  }

  private static List<Segment> without(Segment edge, List<Segment> openings) {
    List<double[]> gaps =
        openings.stream()
            .filter(edge::isInLineWith)
            .map(opening -> sorted(edge.share(opening.from()), edge.share(opening.to())))
            .sorted(Comparator.comparingDouble(gap -> gap[0]))
            .toList();
    List<Segment> pieces = new ArrayList<>();
    double from = 0;
    for (double[] gap : gaps) {
      addPiece(pieces, edge, from, Math.min(1, gap[0]));
      from = Math.max(from, gap[1]);
    }
    addPiece(pieces, edge, from, 1);
    return pieces;
  }

  private static void addPiece(List<Segment> pieces, Segment edge, double from, double to) {
    if ((to - from) * edge.length() > Segment.TOLERANCE) {
      pieces.add(new Segment(edge.at(from), edge.at(to)));
    }
  }

  private static double[] sorted(double first, double second) {
    return new double[] {Math.min(first, second), Math.max(first, second)};
  }
}
