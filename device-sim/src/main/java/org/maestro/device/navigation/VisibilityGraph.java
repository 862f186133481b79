package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;

/**
 * The corners at which a way may bend, as far as one search has met them: those around an obstacle
 * join the graph once it bars a way that walls leave free. A way never bends around what does not
 * bar it, and most of a house's obstacles stand in other rooms. For one thread and one search.
 */
final class VisibilityGraph {

  private static final int NONE = FreeFloor.NONE;

  private final WalledFloor walls;
  private final List<Obstacle> obstacles;
  private final FreeFloor floor;
  private final Corner start;
  private final List<Corner> goals = new ArrayList<>();
  private final List<Corner> aroundWalls = new ArrayList<>();
  private final List<Corner> aroundObstacles = new ArrayList<>();
  private final List<Corner> passed = new ArrayList<>();
  private final BitSet met = new BitSet();
  private final List<Integer> newlyMet = new ArrayList<>();
  private final FreeFloor.Memory memory = new FreeFloor.Memory();

  /**
   * @param start where the body stands; where it is too near to something, each obstacle counts as
   *     met
   * @param goals each of them free
   */
  VisibilityGraph(
      WalledFloor walls,
      List<Obstacle> obstacles,
      FreeFloor floor,
      Point2 start,
      List<Point2> goals) {
    this.walls = walls;
    this.obstacles = obstacles;
    this.floor = floor;
    this.start = new Corner(start, 0, NONE);
    goals.forEach(goal -> this.goals.add(new Corner(goal, 1 + this.goals.size(), NONE)));
    for (Point2 corner : walls.corners()) {
      int index = aroundWalls.size();
      aroundWalls.add(new Corner(corner, 1 + goals.size() + index, index));
    }
    if (!floor.isFree(start)) {
      IntStream.range(0, obstacles.size()).forEach(this::meets);
    }
  }

  /** A corner, or an end of the way, with what a search notes of it. */
  static final class Corner {
    final Point2 at;

    /** Which one goes first of those that promise the same. */
    final int rank;

    /** Metres from the start. */
    double length = Double.POSITIVE_INFINITY;

    Corner before = this;
    boolean passed;
    private final int ofWalls;

    private Corner(Point2 at, int rank, int ofWalls) {
      this.at = at;
      this.rank = rank;
      this.ofWalls = ofWalls;
    }
  }

  /** What goes from corner to corner. */
  interface Search {
    /** Whether it would go there, if that way is free. */
    boolean wants(Corner from, Corner next);

    /** It goes there, by a free way. */
    void goesOn(Corner from, Corner next);
  }

  Corner start() {
    return start;
  }

  List<Corner> goals() {
    return goals;
  }

  boolean isGoal(Corner corner) {
    return corner.rank > 0 && corner.rank <= goals.size();
  }

  /**
   * Lets a search go on from a corner, to all that are straight ahead; to corners around obstacles
   * that it meets now, from wherever it has been.
   */
  void pass(Corner corner, Search search) {
    if (!corner.passed) {
      corner.passed = true;
      passed.add(corner);
    }
    goals.forEach(goal -> go(corner, goal, search));
    if (corner.ofWalls == NONE) {
      aroundWalls.forEach(next -> go(corner, next, search));
    } else {
      for (int next : walls.seenFrom(corner.ofWalls)) {
        go(corner, aroundWalls.get(next), search);
      }
    }
    aroundObstacles.forEach(next -> go(corner, next, search));
    while (!newlyMet.isEmpty()) {
      goAround(newlyMet.remove(newlyMet.size() - 1), search);
    }
  }

  private void goAround(int obstacle, Search search) {
    Obstacle body = obstacles.get(obstacle);
    List<Point2> corners = new ArrayList<>();
    RoutePlanner.addPolygon(corners, body.middle(), body.radius() + walls.radius());
    int rank = 1 + goals.size() + aroundWalls.size() + obstacle * corners.size();
    for (int i = 0; i < corners.size(); i++) {
      Point2 at = corners.get(i);
      if (walls.isFree(at) && isFreeOfObstacles(at)) {
        Corner corner = new Corner(at, rank + i, NONE);
        passed.forEach(from -> go(from, corner, search));
        aroundObstacles.add(corner);
      }
    }
  }

  private void go(Corner from, Corner next, Search search) {
    if (search.wants(from, next) && isFreeWay(from, next)) {
      search.goesOn(from, next);
    }
  }

  /** Whether one can go straight from one to the other; what bars the way is met. */
  private boolean isFreeWay(Corner from, Corner next) {
    boolean knownOfWalls = from.ofWalls != NONE && next.ofWalls != NONE;
    return (knownOfWalls || floor.isFreeOfWalls(from.at, next.at, memory))
        && !meets(floor.firstBar(from.at, next.at))
        && (next.ofWalls == NONE || isFreeOfObstacles(next.at));
  }

  private boolean isFreeOfObstacles(Point2 place) {
    return !meets(floor.firstBarAt(place));
  }

  /** Whether there is one, around which the way may have to go. */
  private boolean meets(int obstacle) {
    if (obstacle != NONE && !met.get(obstacle)) {
      met.set(obstacle);
      newlyMet.add(obstacle);
    }
    return obstacle != NONE;
  }
}
