package org.maestro.sim.world;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.hal.Position;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.time.Clock;
import org.maestro.sim.scene.SimulationException;

/**
 * The places of all bodies, the things that robots hold, and the drives under way. Guarded by the
 * world's lock.
 */
public final class Whereabouts {

  /** Of a robot's way, some hundred drives; what is asked for is that of the last. */
  private static final int MOST_POINTS = 2_048;

  private final Object lock;
  private final Clock clock;
  private final Map<String, Body> bodies = new TreeMap<>();
  private final Map<String, Drive> drives = new TreeMap<>();
  private final Map<String, List<PathPoint>> paths = new TreeMap<>();
  private final Map<String, Duration> driven = new TreeMap<>();

  Whereabouts(Object lock, Clock clock) {
    this.lock = lock;
    this.clock = clock;
  }

  Set<String> names() {
    synchronized (lock) {
      return new TreeSet<>(bodies.keySet());
    }
  }

  public Optional<Body> find(String name) {
    synchronized (lock) {
      return Optional.ofNullable(bodies.get(name));
    }
  }

  /**
   * @throws SimulationException when it is nowhere
   */
  public Body body(String name) {
    synchronized (lock) {
      return find(name)
          .orElseThrow(
              () ->
                  new SimulationException(
                      name + " is nowhere in this world; there are " + bodies.keySet()));
    }
  }

  public void put(Body body) {
    synchronized (lock) {
      bodies.put(body.name(), body);
    }
  }

  Optional<Position> position(String name) {
    synchronized (lock) {
      Body body = bodies.get(name);
      if (body == null) {
        return Optional.empty();
      }
      if (body.holder().isPresent()) {
        return position(body.holder().get());
      }
      return Optional.of(
          drive(name)
              .map(drive -> Position.onFloor(drive.positionAt(clock.now())))
              .orElse(body.position()));
    }
  }

  Optional<String> held(String robot) {
    synchronized (lock) {
      return bodies.values().stream()
          .filter(body -> body.holder().equals(Optional.of(robot)))
          .map(Body::name)
          .findFirst();
    }
  }

  /** What stands in the robot's way: not itself, not what it holds. */
  public List<Obstacle> obstacles(String robot) {
    synchronized (lock) {
      List<Obstacle> obstacles = new ArrayList<>();
      for (Body body : bodies.values()) {
        if (body.isObstacle() && !body.name().equals(robot)) {
          Point2 place = position(body.name()).orElseThrow().floor();
          obstacles.add(new Obstacle(body.name(), place, body.radius()));
        }
      }
      return obstacles;
    }
  }

  /** A body that a thing would overlap if it stood there. */
  public Optional<String> occupant(Position place, String name) {
    synchronized (lock) {
      Body thing = body(name);
      return bodies.values().stream()
          .filter(body -> body.isObstacle() && !body.name().equals(thing.name()))
          .filter(
              body ->
                  position(body.name()).orElseThrow().floor().distance(place.floor())
                      < body.radius() + thing.radius())
          .map(Body::name)
          .findFirst();
    }
  }

  /** Where all that is neither hidden nor held is. */
  public List<Position> placesInTheOpen() {
    synchronized (lock) {
      return bodies.values().stream()
          .filter(Body::isInTheOpen)
          .flatMap(body -> position(body.name()).stream())
          .toList();
    }
  }

  public Optional<Drive> drive(String robot) {
    synchronized (lock) {
      return Optional.ofNullable(drives.get(robot));
    }
  }

  /** Who drives or walks, but for one. */
  public Set<String> movingWithout(String robot) {
    synchronized (lock) {
      Set<String> others = new TreeSet<>(drives.keySet());
      others.remove(robot);
      return others;
    }
  }

  /** For how long it has driven until now. */
  Duration driven(String robot) {
    synchronized (lock) {
      Duration before = driven.getOrDefault(robot, Duration.ZERO);
      return drive(robot)
          .map(drive -> before.plus(clock.now().minus(drive.begun())))
          .orElse(before);
    }
  }

  public void start(String robot, Drive drive) {
    synchronized (lock) {
      drives.put(robot, drive);
    }
  }

  /** Ends a drive where the robot is now. */
  public void stop(String robot) {
    synchronized (lock) {
      drive(robot)
          .ifPresent(
              drive -> {
                note(robot, drive.pathUntil(clock.now()));
                driven.merge(robot, clock.now().minus(drive.begun()), Duration::plus);
                Position place = Position.onFloor(drive.positionAt(clock.now()));
                drives.remove(robot);
                put(body(robot).at(place));
              });
    }
  }

  private void note(String robot, List<PathPoint> driven) {
    List<PathPoint> path = paths.computeIfAbsent(robot, name -> new ArrayList<>());
    path.addAll(driven);
    if (path.size() > MOST_POINTS) {
      path.subList(0, path.size() - MOST_POINTS / 2).clear();
    }
  }

  /** In which direction it drives or last drove, from x towards y; radians. */
  double heading(String name) {
    synchronized (lock) {
      List<PathPoint> path = path(name);
      for (int i = path.size() - 1; i > 0; i--) {
        Point2 from = path.get(i - 1).point();
        Point2 to = path.get(i).point();
        if (from.distance(to) > 0) {
          return Math.atan2(to.y() - from.y(), to.x() - from.x());
        }
      }
      return 0;
    }
  }

  /** Where a robot went, corner by corner, up to now; of a long time the latest. */
  List<PathPoint> path(String robot) {
    synchronized (lock) {
      List<PathPoint> path = new ArrayList<>(paths.getOrDefault(robot, List.of()));
      drive(robot).ifPresent(drive -> path.addAll(drive.pathUntil(clock.now())));
      return List.copyOf(path);
    }
  }
}
