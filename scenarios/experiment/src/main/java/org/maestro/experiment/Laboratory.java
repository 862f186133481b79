package org.maestro.experiment;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.maestro.experiment.setting.Setting;
import org.maestro.experiment.setting.Settings;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.SceneSky;

/**
 * The papers' laboratory by day, with its windows, and shutters or none. Things are put by hand to
 * where they belong before each run, not quite exactly; the sun goes on from run to run.
 */
final class Laboratory {
  static final double WIDTH = 8.4;
  static final double DEPTH = 3;
  static final String ROBOT = "rose";
  static final List<String> CAMERAS = List.of("cam-1", "cam-2", "cam-3");
  static final List<String> THINGS = List.of("GreenObject", "RedObject1", "RedObject2");

  /** Minden, where the papers' laboratory stands; degrees. */
  private static final double LATITUDE = 52.3;

  private static final double NORTH_ABOVE = 90;
  private static final int EQUINOX = 81;
  private static final double MINUTES = 60;
  private static final String START = "world.sun.start";
  private static final String INTERVAL = "world.sun.minutes";
  private static final String CLOUDS = "world.clouds";
  private static final String CHANGE = "world.clouds.change";
  private static final String BY_HAND = "world.placing-noise";

  private Laboratory() {}

  static List<Setting> settings() {
    return List.of(
        Setting.number(
            START, 10, 0, 23, "hours of solar time at the first run; assumed: a morning's work"),
        Setting.number(
            INTERVAL,
            10,
            0,
            600,
            "minutes from run to run; assumed: things are put back and batteries looked after"),
        Setting.number(
            CLOUDS, 0.5, 0, 1, "mean share of the sky that clouds hide; assumed: a usual day"),
        Setting.number(
            CHANGE, 0.5, 0, 1, "greatest difference from that mean; assumed: clouds come and go"),
        Setting.number(
            BY_HAND,
            0.05,
            0,
            0.5,
            "greatest distance on each axis from where a thing is to be put by hand, m; assumed"));
  }

  /**
   * @param carried what may be carried; everything else stands for Bob, whom nobody carries
   * @param noticesGlare whether its cameras notice that something is over-lit
   */
  static Home home(String carried, boolean noticesGlare) {
    String cameras =
        noticesGlare
            ? ""
            : CAMERAS.stream()
                .map("home:%s a :TrustingCamera ."::formatted)
                .collect(Collectors.joining("\n"));
    return Shipped.home("arena-windows", "home:" + carried + " a :Item .", cameras);
  }

  /** The hour of solar time at which a run, counted from 1, begins. */
  static double solarHours(Settings settings, int run) {
    return (settings.number(START) + (run - 1) * settings.number(INTERVAL) / MINUTES) % 24;
  }

  static Scene scene(Settings settings, Home home, int run, long seed) {
    Scene scene = Shipped.scene("arena-windows", home);
    double noise = settings.number(BY_HAND);
    SplittableRandom random = new SplittableRandom(seed);
    for (String thing : THINGS) {
      Scene.Entry entry = scene.of(thing);
      Position place = entry.position().orElseThrow();
      scene =
          scene.with(
              thing,
              entry.at(
                  new Position(
                      place.x() + noise * (2 * random.nextDouble() - 1),
                      place.y() + noise * (2 * random.nextDouble() - 1),
                      place.z())));
    }
    double hours = solarHours(settings, run);
    Map<String, Double> openings = new LinkedHashMap<>();
    home.devices().keySet().stream()
        .filter(device -> device.startsWith("shutter"))
        .forEach(shutter -> openings.put(shutter, 1.0));
    return new Scene(
        scene.name(),
        scene.entries(),
        Optional.of(
            new SceneSky(
                LATITUDE,
                EQUINOX,
                hours,
                NORTH_ABOVE,
                settings.number(CLOUDS),
                settings.number(CHANGE),
                Duration.ofMinutes(10),
                OptionalLong.of(seed),
                OptionalDouble.empty())),
        openings,
        scene.course(),
        scene.states());
  }
}
