package org.maestro.sim.world;

import java.util.List;
import java.util.Optional;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.time.Clock;
import org.maestro.sim.scene.Stop;
import org.maestro.sim.scene.WorldEvent;

/**
 * Lets persons walk, once or in rounds for ever. They walk through whatever stands in their way
 * (assumed): others have to look out.
 */
public final class Walks {

  private final World world;
  private final Clock clock;
  private final double speed;

  public Walks(World world, Clock clock) {
    this.world = world;
    this.clock = clock;
    this.speed = world.persons().speed();
  }

  /** From where the person is, corner by corner, for ever. */
  public void start(String person, List<Stop> corners) {
    walk(person, corners, 0);
  }

  /** From where the person is straight to a place, and no farther. */
  public void go(String person, Point2 to) {
    walk(person, to, () -> {});
  }

  /**
   * From where the person is along a way.
   *
   * @param there done when she has come to its end
   */
  public void go(String person, List<Point2> way, Runnable there) {
    if (way.isEmpty()) {
      there.run();
    } else {
      walk(person, way.get(0), () -> go(person, way.subList(1, way.size()), there));
    }
  }

  private void walk(String person, List<Stop> corners, int next) {
    walk(person, corners.get(next).place(), () -> stay(person, corners, next));
  }

  private void stay(String person, List<Stop> corners, int at) {
    double seconds = corners.get(at).seconds();
    Runnable goOn = () -> walk(person, corners, (at + 1) % corners.size());
    if (seconds > 0) {
      world.later(person, seconds, goOn);
    } else {
      goOn.run();
    }
  }

  private void walk(String person, Point2 to, Runnable then) {
    Point2 here = world.position(person).orElseThrow().floor();
    world.whereabouts().start(person, new Drive(clock.now(), here, List.of(to), speed));
    world.later(
        person,
        Math.max(0.1, here.distance(to) / speed),
        () -> {
          world.whereabouts().stop(person);
          world.tell(WorldEvent.Kind.MOVED, person, Optional.empty());
          then.run();
        });
  }
}
