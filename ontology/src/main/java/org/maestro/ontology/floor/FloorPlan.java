package org.maestro.ontology.floor;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The walls of a home, made from its rooms' outlines and from openings such as those of open doors.
 * Immutable.
 */
public final class FloorPlan {

  private final List<Segment> walls;
  private final WallGrid grid;

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
    this.grid = new WallGrid(walls);
  }

  /** The edges without the openings. A wall between two rooms appears once per room. */
  public List<Segment> walls() {
    return walls;
  }

  /** Whether a wall stands between both points. */
  public boolean isBlocked(Point2 from, Point2 to) {
    return grid.isCrossed(new Segment(from, to));
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
