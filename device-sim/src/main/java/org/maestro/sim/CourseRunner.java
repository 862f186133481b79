package org.maestro.sim;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Point2;
import org.maestro.rats.time.Clock;

/**
 * Lets happen what a scene states: faults in their time, and persons who walk their rounds. They
 * walk through whatever stands in their way (assumed): others have to look out.
 */
final class CourseRunner {

  private static final double NANOS = 1e9;

  /** A slow walk; metres a second, assumed. */
  private static final double WALKING_SPEED = 0.8;

  private final World world;
  private final Clock clock;
  private final Random random;

  CourseRunner(World world, Clock clock, Random random) {
    this.world = world;
    this.clock = clock;
    this.random = random;
  }

  void start(Course course) {
    course.faults().forEach((subject, faults) -> faults.forEach(f -> begin(subject, f)));
    course.walks().forEach((person, corners) -> walk(person, corners, 0));
  }

  private void begin(String subject, ScriptedFault fault) {
    switch (fault.when()) {
      case AT -> later(subject, fault.seconds(), () -> happen(subject, fault));
      case EVERY -> again(subject, fault);
      case UPON -> world.when(subject, fault.event().orElseThrow(), () -> happen(subject, fault));
    }
  }

  /** A Poisson process: the time to the next is spread exponentially. */
  private void again(String subject, ScriptedFault fault) {
    double wait = -Math.log(1 - random.nextDouble()) * fault.seconds();
    later(
        subject,
        wait,
        () -> {
          happen(subject, fault);
          again(subject, fault);
        });
  }

  private void later(String subject, double seconds, Runnable then) {
    clock.schedule(
        Duration.ofNanos(Math.round(seconds * NANOS)),
        subject,
        () -> {
          if (!world.hasEnded()) {
            then.run();
          }
        });
  }

  private void happen(String subject, ScriptedFault fault) {
    List<Double> numbers = fault.numbers();
    switch (fault.deed()) {
      case DIE -> world.die(subject);
      case REVIVE -> world.revive(subject);
      case BREAK -> world.breakDown(subject, "it is broken");
      case REPAIR -> world.repair(subject);
      case FREEZE -> world.freeze(subject, numbers.get(0));
      case LIE -> world.distort(subject, numbers.get(0), 0);
      case DRIFT -> world.distort(subject, 1, numbers.get(0));
      case DROP -> world.drop(subject);
      case WEAKEN -> world.weaken(subject, numbers.get(0));
      case AMBIENT -> world.setAmbient(subject, numbers.get(0));
      case CLOUDS -> world.setClouds(numbers.get(0));
      case MOVE -> world.moveByHand(subject, new Position(numbers.get(0), numbers.get(1), 0));
      case OPEN -> world.setDoor(subject, true);
      case CLOSE -> world.setDoor(subject, false);
    }
  }

  private void walk(String person, List<Point2> corners, int next) {
    Point2 here = world.position(person).orElseThrow().floor();
    Point2 corner = corners.get(next);
    world.start(person, new Drive(clock.now(), here, List.of(corner), WALKING_SPEED));
    later(
        person,
        Math.max(0.1, here.distance(corner) / WALKING_SPEED),
        () -> {
          world.stop(person);
          world.tell(WorldEvent.Kind.MOVED, person, Optional.empty());
          walk(person, corners, (next + 1) % corners.size());
        });
  }
}
