package org.maestro.sim.world;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * The lookout of a body that moves: what it will run into, of walls, of what stands there, and of
 * others that move, as its scanner or its eyes tell it. For one body; clock thread only.
 */
public final class Lookout {

  private static final int MOMENTS = 5;
  private static final double NANOS = 1e9;

  /**
   * A planned way passes obstacles at the very radius; only what is nearer than this less has come
   * in the way.
   */
  private static final double GRAZING_METRES = 0.01;

  private final World world;
  private final String body;
  private final double radius;
  private WalledFloor walls;

  /**
   * @param radius of the body; metres
   */
  public Lookout(World world, String body, double radius) {
    this.world = world;
    this.body = body;
    this.radius = radius;
    this.walls = new WalledFloor(List.of(), radius - GRAZING_METRES);
  }

  /**
   * Whether nothing is in its way.
   *
   * @param ahead straight pieces, from where it is, that it goes within so many seconds
   */
  public boolean isFree(List<Segment> ahead, double seconds) {
    walls = walls.with(world.building().walls());
    RoutePlanner free = new RoutePlanner(walls, world.whereabouts().obstacles(body));
    return ahead.stream()
        .allMatch(
            piece -> free.isFreeWay(piece.from(), piece.to()) && !meetsOthers(piece, seconds));
  }

  private boolean meetsOthers(Segment way, double seconds) {
    for (String other : world.whereabouts().movingWithout(body)) {
      Optional<Drive> drive = world.whereabouts().drive(other);
      if (drive.isPresent()
          && comesNearer(radius + world.radius(other), drive.get(), way, seconds)) {
        return true;
      }
    }
    return false;
  }

  private boolean comesNearer(double apart, Drive other, Segment way, double seconds) {
    double before = way.from().distance(other.positionAt(world.now()));
    for (int i = 1; i <= MOMENTS; i++) {
      double share = (double) i / MOMENTS;
      Duration then = world.now().plusNanos(Math.round(share * seconds * NANOS));
      Point2 here = way.at(share);
      double distance = here.distance(other.positionAt(then));
      if (distance < apart - GRAZING_METRES && distance < before) {
        return true;
      }
    }
    return false;
  }

  /** Another body that moves and that it touches now. */
  public Optional<String> touched() {
    Point2 here = world.position(body).map(Position::floor).orElseThrow();
    return world.whereabouts().movingWithout(body).stream()
        .filter(
            other ->
                world.position(other).orElseThrow().floor().distance(here)
                    < radius + world.radius(other) - GRAZING_METRES)
        .findFirst();
  }
}
