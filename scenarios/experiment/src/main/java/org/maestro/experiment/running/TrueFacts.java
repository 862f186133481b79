package org.maestro.experiment.running;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.device.tasks.FactTemplates;
import org.maestro.hal.DoorDrive;
import org.maestro.hal.Drivers;
import org.maestro.hal.Position;
import org.maestro.hal.Settings;
import org.maestro.hal.ShutterDrive;
import org.maestro.hal.Switch;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sim.SimulatedHome;
import org.maestro.sim.world.FloorMap;
import org.maestro.sim.world.World;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * The truth of a goal in the simulated world at one moment: a knowledge base of its own is told
 * where everything is, how bright it is and how devices are set, and nothing else. What the world
 * does not tell, such as whether a script was carried out, is unknown. For the clock's thread, or
 * while the clock stands.
 */
final class TrueFacts {

  /** What sensors cannot tell from true: they err by 3 % each time (world.sensor.noise). */
  private static final double CLOSE_LIGHT = 0.04;

  private static final Source WORLD = new Source(Source.Kind.OBSERVED, "world");
  private static final String LIGHT = "(= (illuminance %s) %s)";

  private final Home home;
  private final SimulatedHome simulated;
  private final World world;

  /**
   * @param home with the points that the goal names
   */
  TrueFacts(Home home, SimulatedHome simulated) {
    this.home = home;
    this.simulated = simulated;
    this.world = simulated.world();
  }

  /** Light that sensors could not tell from enough, or from little enough, counts as that. */
  Truth of(Formula goal) {
    List<String> rest = rest();
    Truth exactly = with(1, rest, goal);
    if (exactly != Truth.FALSE) {
      return exactly;
    }
    boolean isClose =
        with(1 + CLOSE_LIGHT, rest, goal) == Truth.TRUE
            || with(1 - CLOSE_LIGHT, rest, goal) == Truth.TRUE;
    return isClose ? Truth.TRUE : Truth.FALSE;
  }

  private Truth with(double lightFactor, List<String> rest, Formula goal) {
    List<String> facts = new ArrayList<>(rest);
    for (Individual one : home.individuals().values()) {
      if (one.classes().contains("Location")) {
        lux(one)
            .ifPresent(
                lux ->
                    facts.add(
                        LIGHT.formatted(
                            one.name(), SlPrinter.print(new Term.Number(lightFactor * lux)))));
      }
    }
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      knowledge.state(WORLD, facts);
      return new Evaluation(knowledge.snapshot()).truth(forSome(goal), Map.of());
    }
  }

  /** What nobody has named is looked for among all. */
  private static Formula forSome(Formula goal) {
    List<TypedVariable> open =
        FreeVariables.of(goal).stream()
            .map(name -> new TypedVariable(name, Optional.empty()))
            .toList();
    return open.isEmpty() ? goal : new Formula.Exists(open, goal);
  }

  private Optional<Double> lux(Individual location) {
    boolean isZone =
        world.building().map().areas().stream()
            .anyMatch(area -> area.name().equals(location.name()));
    return isZone
        ? Optional.of(world.lux(location.name()))
        : FloorMap.pose(location, "referencePoint")
            .map(pose -> world.lux(new Position(pose.x(), pose.y(), pose.z())));
  }

  private List<String> rest() {
    List<String> facts = new ArrayList<>();
    for (String name : world.bodies()) {
      Individual one = home.individuals().get(name);
      if (one != null && one.classes().contains("Thing")) {
        place(name, facts);
      }
    }
    for (String id : simulated.devices()) {
      Device device = home.devices().get(id);
      if (device != null) {
        settings(id, new FactTemplates(id, device.reports()), facts);
      }
    }
    return facts;
  }

  private void place(String name, List<String> facts) {
    Optional<String> holder = world.holder(name);
    if (holder.isPresent()) {
      facts.add("(in %s %s)".formatted(name, holder.get()));
      world.bodies().stream()
          .filter(other -> home.individuals().containsKey(other))
          .forEach(other -> facts.add("(not (nextTo %s %s))".formatted(name, other)));
    } else {
      Position at = world.position(name).orElseThrow();
      facts.add(
          "(position %s \"%s %s %s\")"
              .formatted(
                  name, SlPrinter.print(at.x()), SlPrinter.print(at.y()), SlPrinter.print(at.z())));
    }
  }

  /** In the words in which the device itself would tell it. */
  private void settings(String id, FactTemplates words, List<String> facts) {
    Map<String, Term> values = new HashMap<>();
    if (world.lighting().hasLamp(id)) {
      values.put("level", new Term.Number(world.lampLevel(id)));
    }
    Drivers drivers = simulated.drivers(id);
    drivers
        .find(ShutterDrive.class)
        .ifPresent(shutter -> values.put("opening", new Term.Number(world.opening(id))));
    drivers
        .find(DoorDrive.class)
        .ifPresent(door -> values.put("open", new Term.Truth(world.isOpen(id))));
    drivers.find(Switch.class).ifPresent(power -> values.put("on", new Term.Truth(power.isOn())));
    drivers.find(Settings.class).ifPresent(set -> values.putAll(set.values()));
    values.forEach((word, value) -> words.statement(word, value).ifPresent(facts::add));
  }
}
