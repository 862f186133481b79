package org.maestro.sim.world;

import java.util.ArrayList;
import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SimulationException;

/**
 * Charging stations: points of the floor over which a robot stands while its battery charges.
 * Immutable.
 */
final class Stations {

  /** So near a robot has contact; metres; assumed. */
  private static final double CONTACT_METRES = 0.05;

  private final List<Point2> places;

  /**
   * @throws SimulationException when a station of the scene has no place in the home
   */
  Stations(Home home, Scene scene) {
    List<Point2> all = new ArrayList<>();
    for (Individual individual : home.individuals().values()) {
      if (scene.of(individual.name()).charges()) {
        all.add(
            FloorMap.pose(individual, "referencePoint")
                .map(Pose::floor)
                .orElseThrow(
                    () ->
                        new SimulationException(
                            "The scene %s says that %s charges batteries; give it a maestro:referencePoint in the home."
                                .formatted(scene.name(), individual.name()))));
      }
    }
    this.places = List.copyOf(all);
  }

  boolean isAt(Point2 place) {
    return places.stream().anyMatch(station -> station.distance(place) <= CONTACT_METRES);
  }
}
