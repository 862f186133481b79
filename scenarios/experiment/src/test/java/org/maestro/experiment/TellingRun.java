package org.maestro.experiment;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.maestro.experiment.setting.Setting;
import org.maestro.experiment.setting.Settings;

/**
 * A run of an experiment that comes to what a setting is about.
 *
 * @param kind which of its runs
 * @param given what is set, with and without another value of the setting
 * @param name of the setting
 * @param other a value of it that is telling, or the usual one
 */
record TellingRun(
    String experiment, Kind kind, Map<String, String> given, String name, String other) {
  /** Of most runs. */
  private static final long SEED = 3;

  /** Both robots are there until the goal is reached. */
  private static final long SEED_OF_COMINGS = 2;

  /** At this hour and with these clouds the sun comes out right before the goal. */
  private static final long SEED_OF_CLOUDS = 300_012;

  /** What a base without slip never needs. */
  private static final Map<String, String> WHEELS_SLIP = given("world.wheels.slip=0.1");

  private static final Map<String, String> SUN_COMES_OUT = given("world.sun.start=11.8333");

  /** Which run of an experiment. */
  enum Kind {
    PLAIN,
    /** The second of a session. */
    SECOND,
    /** With the pictures that it takes. */
    DRAWN,
    /** Of move-object, one in which the sun comes out right before the goal. */
    SUN_COMES_OUT,
    /** Of illumination, the case in which light does not come back. */
    DARK
  }

  /** Where twice the usual value would not be noticed, or takes long; for one experiment first. */
  private static final Map<String, String> TELLING =
      Map.ofEntries(
          Map.entry("world.arm.payload", "0.04"),
          Map.entry("world.arm.graspTolerance", "0.001"),
          Map.entry("world.arm.placingError", "1"),
          Map.entry("broken-cup world.arm.placingError", "3"),
          Map.entry("world.base.radius", "0.36"),
          Map.entry("world.scanner.range", "0.3"),
          Map.entry("world.wheels.nearMetres", "0.1"),
          Map.entry("world.gripper.bagDiameter", "0.02"),
          Map.entry("world.gripper.vacuum", "0.5"),
          Map.entry("world.gripper.pinch", "0.0005"),
          Map.entry("world.gripper.friction", "0.001"),
          Map.entry("world.gripper.lip", "0.05"),
          Map.entry("world.battery.wattHours", "0.15"),
          Map.entry("world.battery.idleWatts", "100"),
          Map.entry("world.battery.worthTelling", "0.5"),
          Map.entry("world.battery.checkSeconds", "1"),
          Map.entry("world.camera.width", "960"),
          Map.entry("world.camera.height", "540"),
          Map.entry("world.camera.detectionWidth", "64"),
          Map.entry("world.image.mostGain", "1"),
          Map.entry("world.camera.lightError", "0.3"),
          Map.entry("illumination world.camera.frameRate", "10"),
          Map.entry("world.camera.halfLux", "100"),
          Map.entry("world.camera.maximumLux", "50"),
          Map.entry("move-object world.camera.maximumLux", "4000"),
          Map.entry("world.camera.slopeLux", "20"),
          Map.entry("world.camera.washedOutSlopeLux", "1000"),
          Map.entry("world.colour.saturationLux", "20"),
          Map.entry("world.colour.tolerance", "10"),
          Map.entry("world.sensor.greatestLux", "10"),
          Map.entry("world.sensor.leastLux", "60"),
          Map.entry("world.sensor.noise", "0.5"),
          Map.entry("world.sensor.integrationSeconds", "10"),
          Map.entry("world.facade.everySeconds", "1"),
          Map.entry("world.facade.noise", "1"),
          Map.entry("world.facade.worthTelling", "10"),
          Map.entry("world.lamp.transitionSeconds", "30"),
          Map.entry("world.drives.shutterSeconds", "40"),
          Map.entry("world.clouds", "0.1"),
          Map.entry("world.clouds.change", "0.1"));

  private static final Map<String, String> CLEAR_SKY =
      given("world.clouds=0 world.clouds.change=0");
  private static final Map<String, String> BARE_WINDOWS =
      given("world.clouds=0 world.clouds.change=0 world.shutters=false");
  private static final Map<String, String> SUN_AS_IN_THE_PAPER =
      given(
          "world.clouds=0 world.clouds.change=0 world.shutters=false world.camera.noticesGlare=false");
  private static final Map<String, String> FROM_PIXELS = given("world.camera.fromPixels=true");
  private static final Map<String, String> NIGHT = given("world.sun.start=20");

  /** What else is set before and after. */
  private static final Map<String, Map<String, String>> GIVEN =
      Map.ofEntries(
          Map.entry("move-object world.battery.idleWatts", given("world.battery.wattHours=0.4")),
          Map.entry("move-object world.battery.checkSeconds", given("world.battery.wattHours=0.4")),
          Map.entry("move-object world.camera.detectionWidth", FROM_PIXELS),
          Map.entry("illumination world.camera.detectionWidth", FROM_PIXELS),
          Map.entry("move-object world.camera.noticesGlare", BARE_WINDOWS),
          Map.entry("move-object world.camera.maximumLux", SUN_AS_IN_THE_PAPER),
          Map.entry("move-object world.camera.washedOutSlopeLux", SUN_AS_IN_THE_PAPER),
          Map.entry("move-object world.colour.saturationLux", SUN_AS_IN_THE_PAPER),
          Map.entry("move-object world.colour.tolerance", SUN_AS_IN_THE_PAPER),
          Map.entry("move-object world.lamp.transitionSeconds", NIGHT),
          Map.entry("move-object world.sensor.leastLux", NIGHT),
          Map.entry("move-object world.sensor.noise", NIGHT),
          Map.entry("move-object world.drives.shutterSeconds", CLEAR_SKY),
          Map.entry("move-object world.facade.worthTelling", given("world.facade.everySeconds=1")),
          Map.entry("illumination world.camera.washedOutSlopeLux", given("world.dusk=2250")),
          Map.entry("illumination world.colour.tolerance", given("world.dusk=2250")),
          Map.entry(
              "illumination world.colour.saturationLux",
              given("world.dusk=2250 world.colour.tolerance=1")),
          Map.entry("join-leave world.battery.idleWatts", given("world.battery.wattHours=0.2")),
          Map.entry("join-leave world.battery.checkSeconds", given("world.battery.wattHours=0.15")),
          Map.entry("join-leave world.battery.worthTelling", given("world.battery.wattHours=0.2")),
          Map.entry("join-leave world.camera.noticesGlare", given("world.camera.maximumLux=80")),
          Map.entry(
              "join-leave world.colour.tolerance",
              given("world.camera.maximumLux=80 world.camera.noticesGlare=false")),
          Map.entry(
              "join-leave world.colour.saturationLux",
              given(
                  "world.camera.maximumLux=80 world.camera.noticesGlare=false world.colour.tolerance=0.3")),
          Map.entry("broken-cup world.battery.idleWatts", given("world.battery.wattHours=0.15")),
          Map.entry("broken-cup world.battery.checkSeconds", given("world.battery.wattHours=0.15")),
          Map.entry("broken-cup world.base.checkSeconds", given("world.wheels.slip=0.1")));

  private static Map<String, String> given(String assignments) {
    return Arrays.stream(assignments.split(" "))
        .map(assignment -> assignment.split("="))
        .collect(Collectors.toUnmodifiableMap(pair -> pair[0], pair -> pair[1]));
  }

  static TellingRun of(String experiment, String name) {
    Map<String, String> given =
        new TreeMap<>(GIVEN.getOrDefault(experiment + " " + name, Map.of()));
    if (kind(name) == Kind.SUN_COMES_OUT) {
      given.putAll(SUN_COMES_OUT);
    }
    if (name.startsWith("world.scanner.match")
        || name.startsWith("world.wheels.") && !WHEELS_SLIP.containsKey(name)) {
      given.putAll(WHEELS_SLIP);
    }
    return new TellingRun(experiment, kind(name), given, name, usual(experiment, name));
  }

  private static Kind kind(String name) {
    if (name.startsWith("world.dark.")) {
      return Kind.DARK;
    } else if (name.startsWith("world.image.")
        || name.equals("world.camera.width")
        || name.equals("world.camera.height")) {
      return Kind.DRAWN;
    }
    if (name.startsWith("world.facade.")) {
      return Kind.SUN_COMES_OUT;
    }
    return name.equals("world.sun.minutes") ? Kind.SECOND : Kind.PLAIN;
  }

  /** The same with another value of the setting. */
  TellingRun changed() {
    Map<String, String> more = new TreeMap<>(given);
    more.put(
        name, TELLING.getOrDefault(experiment + " " + name, TELLING.getOrDefault(name, twice())));
    return new TellingRun(experiment, kind, more, name, more.get(name));
  }

  private String twice() {
    if (other.equals("true") || other.equals("false")) {
      return String.valueOf(!Boolean.parseBoolean(other));
    } else if (Double.parseDouble(other) == 0) {
      return "0.2";
    }
    return other.contains(".")
        ? String.valueOf(2 * Double.parseDouble(other))
        : String.valueOf(2 * Long.parseLong(other));
  }

  private static String usual(String experiment, String name) {
    return Experiments.named(experiment).orElseThrow().settings().stream()
        .filter(setting -> setting.name().equals(name))
        .map(Setting::usual)
        .findFirst()
        .orElseThrow();
  }

  /** What comes into the experiment's tables, and the bytes of the pictures that are taken. */
  List<Object> written() {
    Settings settings =
        Experiments.settings(Experiments.named(experiment).orElseThrow(), given).settings();
    return switch (experiment) {
      case "illumination" -> lit(settings);
      case "join-leave" -> {
        JoinRun run =
            JoinRun.carryOut(
                1,
                name.equals("world.camera.lightError") ? SEED : SEED_OF_COMINGS,
                JoinRun.Way.REPLANNING,
                settings);
        yield List.of(run.success(), run.seconds(), run.ending().story());
      }
      case "broken-cup" -> {
        CupRun run = CupRun.carryOut(2, SEED, settings);
        yield List.of(run.success(), run.seconds(), run.deeds(), run.ending().story());
      }
      default -> moved(settings);
    };
  }

  private List<Object> lit(Settings settings) {
    LightRun run =
        LightRun.carryOut(
            1, SEED, kind == Kind.DARK ? LightRun.Case.DARK : LightRun.Case.RECOVERY, settings);
    return kind == Kind.DRAWN
        ? List.of(Arrays.hashCode(run.photo().rgb()))
        : List.of(run.samples(), run.story());
  }

  private List<Object> moved(Settings settings) {
    List<MoveRun> runs =
        List.of(
            MoveRun.carryOut(
                kind == Kind.SECOND ? 2 : 1,
                kind == Kind.SUN_COMES_OUT ? SEED_OF_CLOUDS : SEED,
                MoveObject.FIRST,
                settings,
                OptionalDouble.empty(),
                kind == Kind.DRAWN));
    return List.of(
        GoalRun.table(runs).rows(),
        MoveObject.details(runs).rows(),
        GoalRun.story(runs).rows(),
        runs.get(0).pictures().stream().map(picture -> Arrays.hashCode(picture.png())).toList());
  }
}
