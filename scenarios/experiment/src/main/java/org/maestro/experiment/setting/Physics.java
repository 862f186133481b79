package org.maestro.experiment.setting;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.parameters.PhysicalSettings;
import org.maestro.sim.parameters.Quantity;

/**
 * The physics that can be set in experiments: every number of {@link PhysicalParameters}, by its
 * name, but for those that change nothing there.
 */
public final class Physics {
  private static final Map<String, String> USUAL =
      PhysicalSettings.of(PhysicalParameters.standard());
  private static final Map<String, Quantity> QUANTITIES = PhysicalSettings.quantities();
  private static final Set<String> WITHOUT_UNIT = Set.of("1", "true or false");

  /**
   * Of hardware that no home of the papers' experiments has: cameras on robots, bases without
   * wheels of their own and those that turn on the spot before they drive, driven doors, lamps
   * behind switches, sensors of persons, charging stations, thermometers and the rooms' warmth,
   * ears and faces; nor do persons walk there. The wheels' radius, of which no way depends. And the
   * shades of white, of which light and detection do not depend and for which no goal of an
   * experiment asks. What exploration alone has it names itself.
   */
  private static final List<String> ABSENT =
      List.of(
          "world.turn.",
          "world.presence.",
          "world.scanner.memorySeconds",
          "world.recognition.",
          "world.phone.",
          "world.base.checkSeconds",
          "world.wheels.wheelRadius",
          "world.wheels.turnSpeed",
          "world.wheels.aimRadians",
          "world.drives.doorSeconds",
          "world.drives.relaySeconds",
          "world.battery.chargingWatts",
          "world.lamp.white",
          "world.climate.",
          "world.thermometer.",
          "world.speech.",
          "world.person.",
          "world.signal.");

  private Physics() {}

  /**
   * What acts in an experiment.
   *
   * @param idle beginnings of the names of what changes nothing there
   */
  public static List<Setting> settingsWithout(String... idle) {
    return USUAL.keySet().stream()
        .filter(
            name -> Stream.concat(ABSENT.stream(), Arrays.stream(idle)).noneMatch(name::startsWith))
        .map(Physics::setting)
        .toList();
  }

  /** All, of which each acts where a home has that hardware. */
  public static List<Setting> all() {
    return USUAL.keySet().stream().map(Physics::setting).toList();
  }

  /** By its name. */
  public static Setting setting(String name) {
    return new Setting(
        name,
        Objects.requireNonNull(USUAL.get(name)),
        new Setting.Range.Physical(),
        meaning(Objects.requireNonNull(QUANTITIES.get(name))));
  }

  private static String meaning(Quantity quantity) {
    String unit = WITHOUT_UNIT.contains(quantity.unit()) ? "" : ", " + quantity.unit();
    return quantity.meaning() + unit + "; " + quantity.source();
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
