package org.maestro.sim.drivers;

import java.util.Map;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import org.maestro.hal.Area;
import org.maestro.hal.PersonRecognition;
import org.maestro.sim.parameters.RecognitionData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Body;

/** A sensor that tells persons apart in an area: it looks by itself, and tells what has changed. */
final class SimulatedRecognition implements PersonRecognition {
  private final Actuator actuator;
  private final RecognitionData data;
  private final Area area;

  /** In the order of their names, so that the same seed gives the same errors. */
  private final SortedSet<String> persons;

  private final BooleanSupplier canTell;
  private final LastingErrors errors;
  private Map<String, Boolean> told = Map.of();

  private SimulatedRecognition(
      Actuator actuator,
      RecognitionData data,
      Area area,
      SortedSet<String> persons,
      BooleanSupplier canTell) {
    this.actuator = actuator;
    this.data = data;
    this.area = area;
    this.persons = persons;
    this.canTell = canTell;
    this.errors =
        new LastingErrors(actuator, data.missShare(), data.falseShare(), data.errorSeconds());
  }

  /**
   * It looks from now on.
   *
   * @param persons whom it knows
   * @param canTell whether it can tell anything now
   */
  static SimulatedRecognition start(
      Actuator actuator,
      RecognitionData data,
      Area area,
      SortedSet<String> persons,
      BooleanSupplier canTell) {
    SimulatedRecognition sensor = new SimulatedRecognition(actuator, data, area, persons, canTell);
    sensor.told = sensor.looked();
    sensor.goOn();
    return sensor;
  }

  private void goOn() {
    actuator.afterInAnyCase(data.everySeconds(), this::look);
  }

  private void look() {
    Map<String, Boolean> now = looked();
    if (actuator.world().isAlive(actuator.device()) && !now.equals(told)) {
      told = now;
      actuator.tell(WorldEvent.Kind.MEASURED);
    }
    goOn();
  }

  private Map<String, Boolean> looked() {
    Map<String, Boolean> seen = new TreeMap<>();
    if (canTell.getAsBoolean()) {
      persons.forEach(person -> seen.put(person, errors.noticed(person, isHere(person))));
    }
    return Map.copyOf(seen);
  }

  private boolean isHere(String person) {
    return actuator
        .world()
        .whereabouts()
        .find(person)
        .filter(Body::isInTheOpen)
        .flatMap(body -> actuator.world().position(person))
        .filter(place -> area.outline().contains(place.floor()))
        .isPresent();
  }

  @Override
  public Map<String, Boolean> persons() {
    return told;
  }
}
