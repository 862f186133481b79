package org.maestro.experiment.setting;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.sim.PhysicalParameters;
import org.maestro.sim.PhysicalSettings;

/**
 * The physics that can be set in every experiment: every number of {@link PhysicalParameters}, by
 * its name, but for those of hardware that no experiment's home has.
 */
public final class Physics {
  private static final Map<String, String> USUAL =
      PhysicalSettings.of(PhysicalParameters.standard());

  /**
   * Wheels of their own and cameras on robots, driven doors, lamps behind switches, charging
   * stations.
   */
  private static final List<String> ABSENT =
      List.of(
          "world.turn.",
          "world.wheels.wheelRadius",
          "world.wheels.halfLength",
          "world.wheels.halfWidth",
          "world.wheels.turnSpeed",
          "world.wheels.controlSeconds",
          "world.wheels.nearMetres",
          "world.wheels.aimRadians",
          "world.drives.doorSeconds",
          "world.drives.relaySeconds",
          "world.battery.chargingWatts");

  private Physics() {}

  public static List<Setting> settings() {
    return USUAL.entrySet().stream()
        .filter(entry -> ABSENT.stream().noneMatch(entry.getKey()::startsWith))
        .map(
            entry ->
                new Setting(
                    entry.getKey(),
                    entry.getValue(),
                    new Setting.Range.Physical(),
                    "physics; its source is stated in PhysicalParameters"))
        .toList();
  }

  public static PhysicalParameters of(Settings settings) {
    Map<String, String> changed = new LinkedHashMap<>();
    settings.known().stream()
        .filter(setting -> setting.range() instanceof Setting.Range.Physical)
        .filter(setting -> !settings.value(setting).equals(setting.usual()))
        .forEach(setting -> changed.put(setting.name(), settings.value(setting)));
    return PhysicalParameters.standard().with(changed);
  }
}
