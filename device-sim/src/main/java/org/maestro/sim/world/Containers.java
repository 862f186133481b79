package org.maestro.sim.world;

import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;

/** The containers of a home: what is in one is out of sight, and out of robots' way. Immutable. */
public final class Containers {
  private static final String CONTAINER = "Container";

  /** What is no farther from the middle is in it; a counter that begins beside it is not. */
  private static final double OPENING_METRES = 0.1;

  private final Set<Position> middles;

  Containers(Home home) {
    this.middles =
        home.individuals().values().stream()
            .filter(one -> one.classes().contains(CONTAINER))
            .flatMap(
                one -> FloorMap.pose(one, "pose").or(() -> FloorMap.pose(one, "position")).stream())
            .map(pose -> new Position(pose.x(), pose.y(), pose.z()))
            .collect(Collectors.toSet());
  }

  /** The middle of the container in which a place is. */
  public Optional<Position> at(Position place) {
    return middles.stream()
        .filter(
            middle ->
                middle.floor().distance(place.floor()) <= OPENING_METRES
                    && Math.abs(middle.z() - place.z()) <= OPENING_METRES)
        .findFirst();
  }
}
