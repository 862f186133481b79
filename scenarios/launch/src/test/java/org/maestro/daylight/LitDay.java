package org.maestro.daylight;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.TreeSet;
import org.maestro.assembly.AgentlessSite;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Geometry;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.Positions;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.World;
import org.maestro.sl.Term;

/**
 * Some hours in which a goal of light on the desk is held, second by second: how long it was not
 * so, and what energy the lamps took beside the least that would have done at each moment, found by
 * trying all settings.
 *
 * @param toldLimits the light less or more than which the sensor surely tells from what is wished
 * @param longestDarkSeconds for which it was surely too dark without a break
 * @param longestBrightSeconds the same for too much light
 * @param seconds too dark or too bright, in sum
 * @param used watt-hours of the lamps
 * @param least watt-hours that the best settings of every moment would take
 * @param alwaysOn watt-hours of all lamps at full level
 * @param changes how often a lamp or shutter was set
 * @param powers all powers that were drawn
 * @param openings all openings that the shutter had
 */
record LitDay(
    Limits toldLimits,
    int longestDarkSeconds,
    int longestBrightSeconds,
    int seconds,
    double used,
    double least,
    double alwaysOn,
    int changes,
    TreeSet<Double> powers,
    TreeSet<Double> openings) {

  /** Three standard deviations of the sensor. */
  private static final double SURE = 0.03;

  private static final double[] LEVELS = {0, 0.25, 0.5, 1};
  private static final double[] OPENINGS = {0, 0.5, 1};
  private static final double SECONDS_PER_HOUR = 3600;
  private static final String DESK = "desk";
  private static final String SHUTTER = "shutter";

  /** Lux. */
  record Limits(double least, double most) {
    boolean hold(double lux) {
      return lux >= least && lux <= most;
    }

    Limits told() {
      return new Limits(least * (1 - SURE), most * (1 + SURE));
    }
  }

  private record Lamp(String name, double watts, double gain) {}

  private record Choice(double watts, double lux) {}

  static LitDay of(Home home, Scene scene, long seed, Limits wished, Duration hours) {
    List<Lamp> lamps = lamps(home);
    List<Choice> choices = choices(lamps);
    Position desk = new Position(2.1, 3, 0.75);
    Limits told = wished.told();
    TreeSet<Double> powers = new TreeSet<>();
    TreeSet<Double> openings = new TreeSet<>();
    int[] spell = new int[2];
    int[] longest = new int[2];
    int wrong = 0;
    int[] changes = new int[1];
    double used = 0;
    double least = 0;
    try (AgentlessSite site = AgentlessSite.start(home, scene, seed)) {
      World world = site.world();
      world.listen(event -> changes[0] += event.kind() == WorldEvent.Kind.ADJUST ? 1 : 0);
      site.pursue(goal(wished), outcome -> {});
      site.clock().run(Duration.ofSeconds(3));
      for (int second = 0; second < hours.toSeconds(); second++) {
        site.clock().run(Duration.ofSeconds(1));
        double lux = world.lux(desk);
        double watts =
            lamps.stream().mapToDouble(lamp -> lamp.watts() * world.lampLevel(lamp.name())).sum();
        powers.add(watts);
        openings.add(world.opening(SHUTTER));
        used += watts / SECONDS_PER_HOUR;
        boolean[] off = {lux < told.least(), lux > told.most()};
        double best = least(choices, wished, world.daylightWithOpenShutters(desk));
        least += Math.min(best, watts) / SECONDS_PER_HOUR;
        for (int i = 0; i < off.length; i++) {
          spell[i] = off[i] && Double.isFinite(best) ? spell[i] + 1 : 0;
          longest[i] = Math.max(longest[i], spell[i]);
          wrong += spell[i] > 0 ? 1 : 0;
        }
      }
    }
    double all = lamps.stream().mapToDouble(Lamp::watts).sum();
    return new LitDay(
        told,
        longest[0],
        longest[1],
        wrong,
        used,
        least,
        all * hours.toSeconds() / SECONDS_PER_HOUR,
        changes[0],
        powers,
        openings);
  }

  private static String goal(Limits wished) {
    String enough = "(>= (illuminance desk) %s)".formatted(wished.least());
    return Double.isInfinite(wished.most())
        ? "(keep %s)".formatted(enough)
        : "(keep (and %s (<= (illuminance desk) %s)))".formatted(enough, wished.most());
  }

  /** The least power that would do, infinite when nothing does. */
  private static double least(List<Choice> choices, Limits wished, double daylight) {
    return choices.stream()
        .filter(
            choice ->
                Arrays.stream(OPENINGS)
                    .anyMatch(opening -> wished.hold(choice.lux() + opening * daylight)))
        .mapToDouble(Choice::watts)
        .findFirst()
        .orElse(Double.POSITIVE_INFINITY);
  }

  /** All levels of all lamps, the least power first. */
  private static List<Choice> choices(List<Lamp> lamps) {
    List<Choice> choices = List.of(new Choice(0, 0));
    for (Lamp lamp : lamps) {
      List<Choice> longer = new ArrayList<>();
      for (Choice choice : choices) {
        for (double level : LEVELS) {
          longer.add(
              new Choice(
                  choice.watts() + level * lamp.watts(), choice.lux() + level * lamp.gain()));
        }
      }
      choices = longer;
    }
    return choices.stream().sorted(Comparator.comparingDouble(Choice::watts)).toList();
  }

  private static List<Lamp> lamps(Home home) {
    Geometry geometry = new Geometry(home);
    List<Lamp> lamps = new ArrayList<>();
    for (Device device : home.devices().values()) {
      double gain = geometry.luxAt(device.id(), DESK, Positions.UNKNOWN).orElse(0);
      if (gain > 0) {
        lamps.add(new Lamp(device.id(), power(device.individual()), gain));
      }
    }
    return lamps;
  }

  private static double power(Individual lamp) {
    return ((Term.Number) lamp.properties().get("power").get(0)).value();
  }
}
