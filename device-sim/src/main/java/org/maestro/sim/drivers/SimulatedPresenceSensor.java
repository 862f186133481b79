package org.maestro.sim.drivers;

import java.util.Set;
import org.maestro.hal.Area;
import org.maestro.hal.PresenceSensor;
import org.maestro.sim.parameters.PresenceData;
import org.maestro.sim.scene.WorldEvent;

/** A sensor of persons in an area: it looks by itself, and tells when that has changed. */
final class SimulatedPresenceSensor implements PresenceSensor {
  private final Actuator actuator;
  private final PresenceData data;
  private final Area area;
  private final Set<String> robots;
  private final LastingErrors errors;
  private boolean told;

  private SimulatedPresenceSensor(
      Actuator actuator, PresenceData data, Area area, Set<String> robots) {
    this.actuator = actuator;
    this.data = data;
    this.area = area;
    this.robots = robots;
    this.errors =
        new LastingErrors(actuator, data.missShare(), data.falseShare(), data.errorSeconds());
  }

  /**
   * It looks from now on.
   *
   * @param robots which it tells from persons by their way of moving
   */
  static SimulatedPresenceSensor start(
      Actuator actuator, PresenceData data, Area area, Set<String> robots) {
    SimulatedPresenceSensor sensor = new SimulatedPresenceSensor(actuator, data, area, robots);
    sensor.told = sensor.looked();
    sensor.goOn();
    return sensor;
  }

  private void goOn() {
    actuator.afterInAnyCase(data.everySeconds(), this::look);
  }

  private void look() {
    boolean now = looked();
    if (actuator.world().isAlive(actuator.device()) && now != told) {
      told = now;
      actuator.tell(WorldEvent.Kind.MEASURED);
    }
    goOn();
  }

  private boolean looked() {
    return errors.noticed("", isSomebodyHere());
  }

  private boolean isSomebodyHere() {
    return actuator.world().bodies().stream()
        .filter(name -> !robots.contains(name))
        .anyMatch(this::isPersonHere);
  }

  /** Who walks is where she is now, not where she set out. */
  private boolean isPersonHere(String name) {
    return actuator
        .world()
        .whereabouts()
        .find(name)
        .filter(body -> body.isInTheOpen() && body.radius() >= data.leastRadius())
        .flatMap(body -> actuator.world().position(name))
        .filter(place -> area.outline().contains(place.floor()))
        .isPresent();
  }

  @Override
  public boolean isSomebodyThere() {
    return told;
  }
}
