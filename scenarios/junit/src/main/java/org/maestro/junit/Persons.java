package org.maestro.junit;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import org.maestro.assembly.LocalSite;
import org.maestro.device.navigation.Route;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.world.Walks;
import org.maestro.sim.world.World;

/** The persons of the home, who walk about in it. For the test's thread. */
public final class Persons {

  /** A person's shoulders pass a wall by as much. */
  private static final double RADIUS_METRES = 0.25;

  private final LocalSite site;
  private final Duration patience;

  Persons(LocalSite site, Duration patience) {
    this.site = site;
    this.patience = patience;
  }

  /**
   * Has a person walk to a room, through doors that are open, and lets time pass until she is
   * there; fails the test when there is no way.
   *
   * @param room or zone, by its name in the home
   */
  public Persons walk(String person, String room) {
    World world = site.world();
    Point2 here = place(person);
    WalledFloor floor = new WalledFloor(world.building().walls(), RADIUS_METRES);
    Route route =
        new RoutePlanner(floor, List.of())
            .shortest(here, List.of(world.building().map().area(room).reference()))
            .orElseThrow(
                () ->
                    new StageException(
                        "There is no way for %s to %s that is open.".formatted(person, room)));
    AtomicBoolean there = new AtomicBoolean();
    new Walks(world, site.clock()).go(person, route.way(), () -> there.set(true));
    if (!site.runUntil(there::get, patience)) {
      throw new StageException(
          "%s did not come to %s within %s.".formatted(person, room, patience));
    }
    return this;
  }

  private Point2 place(String person) {
    return site.world()
        .position(person)
        .orElseThrow(() -> new StageException("The scene does not say where " + person + " is."))
        .floor();
  }
}
