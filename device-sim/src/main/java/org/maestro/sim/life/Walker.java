package org.maestro.sim.life;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.device.navigation.Route;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.time.Clock;
import org.maestro.sim.parameters.PersonData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Drive;
import org.maestro.sim.world.Lookout;
import org.maestro.sim.world.World;

/**
 * A person who walks with her eyes open: round what stands there, through doors that are open, and
 * no farther when something comes in her way. She leaves doors as they are. Clock thread only.
 */
final class Walker {
  private static final double NANOS = 1e9;
  private static final int MOST_WAYS = 3;

  private final World world;
  private final Clock clock;
  private final String person;
  private final Lookout lookout;
  private WalledFloor floor;

  Walker(World world, Clock clock, String person) {
    this.world = world;
    this.clock = clock;
    this.person = person;
    this.lookout = new Lookout(world, person, world.radius(person));
    this.floor = new WalledFloor(List.of(), world.radius(person));
  }

  World world() {
    return world;
  }

  String person() {
    return person;
  }

  PersonData data() {
    return world.persons();
  }

  Point2 here() {
    return world.position(person).orElseThrow().floor();
  }

  void after(double seconds, Runnable action) {
    world.later(person, seconds, action);
  }

  /**
   * Walks to the nearest of some places that she can reach.
   *
   * @param ended run when she stands still, there or where she gave up
   */
  void walk(List<Point2> places, Runnable ended) {
    walk(places, MOST_WAYS, ended);
  }

  private void walk(List<Point2> places, int ways, Runnable ended) {
    Optional<Route> route = ways == 0 ? Optional.empty() : route(places);
    if (route.isEmpty() || route.get().way().isEmpty()) {
      ended.run();
      return;
    }
    Drive drive = new Drive(clock.now(), here(), route.get().way(), data().speed());
    world.whereabouts().start(person, drive);
    goOn(drive, ended, () -> after(data().patienceSeconds(), () -> walk(places, ways - 1, ended)));
  }

  private Optional<Route> route(List<Point2> places) {
    floor = floor.with(world.building().walls());
    return new RoutePlanner(floor, world.whereabouts().obstacles(person)).shortest(here(), places);
  }

  private void goOn(Drive drive, Runnable ended, Runnable barred) {
    Duration now = clock.now();
    double left = drive.begun().plus(drive.duration()).minus(now).toNanos() / NANOS;
    if (!world.whereabouts().drive(person).equals(Optional.of(drive))) {
      ended.run();
    } else if (left <= 0) {
      stand();
      ended.run();
    } else if (!lookout.isFree(drive.ahead(now, data().aheadSeconds()), data().aheadSeconds())) {
      stand();
      barred.run();
    } else {
      after(Math.min(left, data().lookSeconds()), () -> goOn(drive, ended, barred));
    }
  }

  private void stand() {
    world.whereabouts().stop(person);
    world.tell(WorldEvent.Kind.MOVED, person, Optional.empty());
  }
}
