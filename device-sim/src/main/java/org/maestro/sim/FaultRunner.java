package org.maestro.sim;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.function.Function;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.link.BadLink;
import org.maestro.sim.scene.Deed;
import org.maestro.sim.scene.ScriptedFault;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.world.Walks;
import org.maestro.sim.world.World;

/** Lets faults happen: in their time, at random, or upon an event. */
final class FaultRunner {

  private static final double NANOS = 1e9;

  private final Home home;
  private final World world;
  private final Clock clock;
  private final Random random;
  private final Function<String, BadLink> links;
  private final Optional<InProcessBus> bus;

  /**
   * @param links of members, by their id
   * @param bus to cut members off it, or to stop it
   */
  FaultRunner(
      Home home,
      World world,
      Clock clock,
      Random random,
      Function<String, BadLink> links,
      Optional<InProcessBus> bus) {
    this.home = home;
    this.world = world;
    this.clock = clock;
    this.random = random;
    this.links = links;
    this.bus = bus;
  }

  /**
   * @param subject the device, thing, zone or door; empty for the home itself
   * @throws SimulationException when this cannot happen to it
   */
  void begin(String subject, ScriptedFault fault) {
    require(subject, fault);
    switch (fault.when()) {
      case AT -> world.later(subject, fault.seconds(), () -> happen(subject, fault));
      case EVERY -> again(subject, fault);
      case UPON -> {
        ScriptedFault.Cause cause = fault.cause().orElseThrow();
        world.when(cause.subject().orElse(subject), cause.kind(), () -> happen(subject, fault));
      }
    }
  }

  /** A Poisson process: the time to the next is spread exponentially. */
  private void again(String subject, ScriptedFault fault) {
    double wait = -Math.log(1 - random.nextDouble()) * fault.seconds();
    world.later(
        subject,
        wait,
        () -> {
          happen(subject, fault);
          again(subject, fault);
        });
  }

  private void require(String subject, ScriptedFault fault) {
    Deed deed = fault.deed();
    String word = deed.name().toLowerCase(Locale.ROOT);
    if (!fits(deed.subject(), subject)) {
      throw new SimulationException(
          "The fault %s is for %s, not for %s."
              .formatted(word, deed.subject().words(), subject.isEmpty() ? "the home" : subject));
    }
    if (deed == Deed.BLOCK
        && !world.building().map().doors().containsKey(fault.name().orElseThrow())) {
      throw new SimulationException(
          "The fault %s names no door of this home; there are %s."
              .formatted(word, world.building().map().doors().keySet()));
    }
    if ((deed == Deed.OFFLINE || deed == Deed.ONLINE) && bus.isEmpty()) {
      throw new SimulationException(
          "The fault %s needs the bus within the process, on the stepped clock; with a broker, stop that, or say lose 1."
              .formatted(word));
    }
    fault
        .cause()
        .flatMap(ScriptedFault.Cause::subject)
        .filter(name -> !home.individuals().containsKey(name))
        .ifPresent(
            name -> {
              throw new SimulationException(
                  "The fault %s waits for %s, which the home does not have.".formatted(word, name));
            });
  }

  private boolean fits(Deed.Subject kind, String subject) {
    boolean device = home.devices().containsKey(subject);
    return switch (kind) {
      case DEVICE -> device;
      case ROBOT -> device && world.whereabouts().find(subject).isPresent();
      case LAMP -> world.lighting().hasLamp(subject);
      case DEVICE_OR_HOME -> device || subject.isEmpty();
      case ZONE ->
          world.building().map().areas().stream().anyMatch(area -> area.name().equals(subject));
      case HOME -> subject.isEmpty();
      case THING -> world.whereabouts().find(subject).isPresent();
      case DOOR -> world.building().map().doors().containsKey(subject);
    };
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
      case SLIP -> world.slip(subject, numbers.get(0));
      case DROP -> world.drop(subject);
      case CHARGE -> world.charge(subject, numbers.get(0));
      case WEAKEN -> world.weaken(subject, numbers.get(0));
      case LOSE -> links.apply(subject).lose(numbers.get(0));
      case DELAY ->
          links.apply(subject).delay(Duration.ofNanos(Math.round(numbers.get(0) * NANOS)));
      case DUPLICATE -> links.apply(subject).repeat(numbers.get(0));
      case OFFLINE -> offline(subject);
      case ONLINE -> online(subject);
      case DARK -> world.darken(subject);
      case AMBIENT -> world.setAmbient(subject, numbers.get(0));
      case CLOUDS -> world.setClouds(numbers.get(0));
      case SUN -> world.setClouds(0);
      case WALK -> new Walks(world, clock).go(subject, new Point2(numbers.get(0), numbers.get(1)));
      case MOVE -> world.moveByHand(subject, new Position(numbers.get(0), numbers.get(1), 0));
      case BLOCK -> world.moveByHand(subject, middleOf(fault.name().orElseThrow()));
      case HIDE -> world.hide(subject, true);
      case SHOW -> world.hide(subject, false);
      case OPEN -> world.setDoor(subject, true);
      case CLOSE -> world.setDoor(subject, false);
    }
  }

  private void offline(String subject) {
    if (subject.isEmpty()) {
      bus.orElseThrow().stop();
    } else {
      bus.orElseThrow().cut(subject);
    }
  }

  private void online(String subject) {
    if (subject.isEmpty()) {
      bus.orElseThrow().restart();
    } else {
      bus.orElseThrow().mend(subject);
    }
  }

  private Position middleOf(String door) {
    Segment opening = Objects.requireNonNull(world.building().map().doors().get(door));
    Point2 middle = opening.at(0.5);
    return Position.onFloor(middle);
  }
}
