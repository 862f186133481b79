package org.maestro.sim.drivers;

import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.hal.ContentsReader;
import org.maestro.hal.Position;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Body;

/** A reader of the tags of what is in a container. It misses none (assumed). */
final class SimulatedContentsReader implements ContentsReader {
  /** Time of a reading; assumed. */
  private static final double READING_SECONDS = 1;

  private final Actuator actuator;
  private final Position middle;

  /**
   * @param middle of the container
   */
  SimulatedContentsReader(Actuator actuator, Position middle) {
    this.actuator = actuator;
    this.middle = middle;
  }

  @Override
  public void read(Consumer<Set<String>> read, Consumer<String> failed) {
    actuator.command(
        WorldEvent.Kind.MEASURED, READING_SECONDS, failed, () -> read.accept(contents()));
  }

  private Set<String> contents() {
    Set<String> contents = new TreeSet<>();
    for (String name : actuator.world().bodies()) {
      actuator
          .world()
          .whereabouts()
          .find(name)
          .filter(this::isInside)
          .ifPresent(body -> contents.add(name));
    }
    return contents;
  }

  private boolean isInside(Body body) {
    return body.holder().isEmpty()
        && actuator.world().containers().at(body.position()).equals(Optional.of(middle));
  }
}
