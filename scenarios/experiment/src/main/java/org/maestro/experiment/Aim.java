package org.maestro.experiment;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Supplier;
import org.maestro.experiment.running.TrialSite;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.World;

/**
 * The place for which a robot has headed to grasp something or to put it down there (Three-layered
 * architecture, 5.2; M94): what it meant, and what truly stands there.
 *
 * @param second since the goal was stated
 * @param grasping whether it means to take it; otherwise, to put something down beside it
 * @param meant what it takes the thing for that stands there
 * @param truly what stands there in the simulated world; empty when nothing does
 */
record Aim(double second, boolean grasping, String meant, Optional<String> truly) {

  /** As far as an arm reaches with its slack, and as far away as something is put down. */
  private static final double THERE_METRES = 0.96;

  private static final double MILLIS = 1e3;

  /** Whether another thing is there than it means. */
  boolean isOccupied() {
    return truly.filter(thing -> !thing.equals(meant)).isPresent();
  }

  String text() {
    return String.format(
        Locale.ROOT,
        "%.1f s: %s %s, and there is %s",
        second,
        grasping ? "grasps" : "puts down beside",
        meant,
        truly.orElse("nothing"));
  }

  /**
   * Notes from now on where the laboratory's robot heads.
   *
   * @return what was noted by then
   */
  static Supplier<List<Aim>> watched(TrialSite site, MoveRun.Job job) {
    List<Aim> aims = new CopyOnWriteArrayList<>();
    double begun = site.clock().now().toMillis() / MILLIS;
    site.world()
        .listen(
            event -> {
              boolean isGrasp = event.kind() == WorldEvent.Kind.GRASP;
              boolean isRelease = event.kind() == WorldEvent.Kind.RELEASE;
              if (event.subject().equals(Laboratory.ROBOT) && (isGrasp || isRelease)) {
                aims.add(
                    new Aim(
                        event.at().toMillis() / MILLIS - begun,
                        isGrasp,
                        isGrasp ? job.carried() : job.target(),
                        there(site.world())));
              }
            });
    return () -> List.copyOf(aims);
  }

  /** What lies nearest to the robot, and in nobody's hand. */
  private static Optional<String> there(World world) {
    Point2 robot = world.position(Laboratory.ROBOT).orElseThrow().floor();
    return Laboratory.THINGS.stream()
        .filter(thing -> world.holder(thing).isEmpty())
        .filter(thing -> distance(world, thing, robot) <= THERE_METRES)
        .min(Comparator.comparingDouble(thing -> distance(world, thing, robot)));
  }

  private static double distance(World world, String thing, Point2 robot) {
    return world
        .position(thing)
        .map(place -> place.floor().distance(robot))
        .orElse(Double.POSITIVE_INFINITY);
  }
}
