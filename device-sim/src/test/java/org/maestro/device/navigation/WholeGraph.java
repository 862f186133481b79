package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** Lengths of ways by Dijkstra over all corners there are, each held against all others. */
final class WholeGraph {

  private final List<Point2> corners = new ArrayList<>();
  private final FreeFloor floor;

  WholeGraph(List<Segment> walls, List<Obstacle> obstacles, double radius) {
    WalledFloor walled = new WalledFloor(walls, radius);
    this.floor = new FreeFloor(walled, obstacles);
    corners.addAll(walled.corners());
    obstacles.forEach(
        body -> RoutePlanner.addPolygon(corners, body.middle(), body.radius() + radius));
    corners.removeIf(corner -> !floor.isFree(corner));
  }

  OptionalDouble shortest(Point2 start, List<Point2> goals) {
    List<Point2> nodes = new ArrayList<>(List.of(start));
    goals.stream().filter(floor::isFree).forEach(nodes::add);
    int firstCorner = nodes.size();
    nodes.addAll(corners);
    double[] length = new double[nodes.size()];
    Arrays.fill(length, Double.POSITIVE_INFINITY);
    length[0] = 0;
    boolean[] passed = new boolean[nodes.size()];
    while (true) {
      int node = -1;
      for (int i = 0; i < nodes.size(); i++) {
        if (!passed[i] && !Double.isInfinite(length[i]) && (node < 0 || length[i] < length[node])) {
          node = i;
        }
      }
      if (node < 0) {
        return OptionalDouble.empty();
      }
      if (node > 0 && node < firstCorner) {
        return OptionalDouble.of(length[node]);
      }
      passed[node] = true;
      for (int next = 1; next < nodes.size(); next++) {
        double reached = length[node] + nodes.get(node).distance(nodes.get(next));
        if (reached < length[next] && floor.isFreeWay(nodes.get(node), nodes.get(next))) {
          length[next] = reached;
        }
      }
    }
  }
}
