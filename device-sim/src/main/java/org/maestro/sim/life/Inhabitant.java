package org.maestro.sim.life;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.maestro.hal.Area;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.parameters.PersonData;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.World;

/**
 * One person's life: she stays for a while where she is, and then goes elsewhere, stands in a door,
 * or takes a thing, which she puts down where she comes to next. Clock thread only.
 */
final class Inhabitant {
  private static final int SIDES = 12;

  private final Walker walker;
  private final World world;
  private final PersonData data;
  private final double staySeconds;
  private final Random random;

  Inhabitant(Walker walker, double staySeconds, Random random) {
    this.walker = walker;
    this.world = walker.world();
    this.data = walker.data();
    this.staySeconds = staySeconds;
    this.random = random;
  }

  /** For a time that is spread exponentially; then she does something. */
  void stay() {
    walker.after(-Math.log(1 - random.nextDouble()) * staySeconds, this::go);
  }

  private void go() {
    double drawn = random.nextDouble();
    List<Body> things = things();
    List<Segment> doors = openDoors();
    if (world.held(walker.person()).isPresent()) {
      walker.walk(List.of(anyPlace()), () -> handle(this::putDown));
    } else if (drawn < data.takeShare() && !things.isEmpty()) {
      take(anyOf(things).name());
    } else if (drawn > 1 - data.doorShare() && !doors.isEmpty()) {
      walker.walk(List.of(anyOf(doors).middle()), this::stay);
    } else {
      walker.walk(List.of(anyPlace()), this::stay);
    }
  }

  private void take(String thing) {
    walker.walk(
        around(place(thing)),
        () ->
            handle(
                () -> {
                  if (walker.here().distance(place(thing)) <= data.reach()) {
                    world.takeByHand(walker.person(), thing);
                  }
                }));
  }

  private void handle(Runnable deed) {
    walker.after(
        data.handlingSeconds(),
        () -> {
          deed.run();
          stay();
        });
  }

  private void putDown() {
    world.putDownByHand(walker.person());
  }

  /** Where she can stand to take what is there. */
  private List<Point2> around(Point2 place) {
    double distance = (world.radius(walker.person()) + data.reach()) / 2;
    return IntStream.range(0, SIDES)
        .mapToDouble(side -> 2 * Math.PI * side / SIDES)
        .mapToObj(
            angle ->
                new Point2(
                    place.x() + distance * Math.cos(angle), place.y() + distance * Math.sin(angle)))
        .toList();
  }

  private Point2 place(String thing) {
    return world.position(thing).orElseThrow().floor();
  }

  private List<Body> things() {
    return world.bodies().stream()
        .flatMap(name -> world.whereabouts().find(name).stream())
        .filter(body -> !body.name().equals(walker.person()))
        .filter(body -> body.isInTheOpen() && body.radius() <= data.largestTaken())
        .filter(body -> body.mass() <= data.heaviestTaken())
        .toList();
  }

  private List<Segment> openDoors() {
    List<Segment> open = new ArrayList<>();
    world
        .building()
        .map()
        .doors()
        .forEach(
            (door, opening) -> {
              if (world.isOpen(door)) {
                open.add(opening);
              }
            });
    return open;
  }

  /** Somewhere in the rectangle around an area; what nobody can stand at is not gone to. */
  private Point2 anyPlace() {
    Area area = anyOf(world.building().map().areas());
    List<Point2> corners = area.outline().corners();
    double left = corners.stream().mapToDouble(Point2::x).min().orElseThrow();
    double right = corners.stream().mapToDouble(Point2::x).max().orElseThrow();
    double lower = corners.stream().mapToDouble(Point2::y).min().orElseThrow();
    double upper = corners.stream().mapToDouble(Point2::y).max().orElseThrow();
    return new Point2(
        left + random.nextDouble() * (right - left), lower + random.nextDouble() * (upper - lower));
  }

  private <T> T anyOf(List<T> all) {
    return all.get(random.nextInt(all.size()));
  }
}
