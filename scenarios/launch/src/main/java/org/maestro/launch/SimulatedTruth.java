package org.maestro.launch;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.assembly.LocalSite;
import org.maestro.console.truth.TrueThing;
import org.maestro.console.truth.Truth;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sim.world.World;

/** The truth of a simulated world, as the console has it told. */
final class SimulatedTruth implements Truth {
  private final World world;
  private final List<String> doors;
  private final List<String> lamps;

  /**
   * @param home for which the world was made
   */
  private SimulatedTruth(World world, Home home) {
    this.world = world;
    this.doors =
        home.individuals().values().stream()
            .filter(one -> one.classes().contains("Door"))
            .map(Individual::name)
            .toList();
    this.lamps = home.devices().keySet().stream().filter(world.lighting()::hasLamp).toList();
  }

  static SimulatedTruth of(LocalSite site) {
    return new SimulatedTruth(site.world(), site.home());
  }

  @Override
  public List<TrueThing> now() {
    List<TrueThing> things = new ArrayList<>();
    world.bodies().forEach(name -> things.add(body(name)));
    lamps.forEach(name -> things.add(lamp(name)));
    doors.forEach(name -> things.add(door(name)));
    return things;
  }

  private TrueThing body(String name) {
    return new TrueThing(
        name,
        world.position(name).map(place -> new TrueThing.Spot(place.x(), place.y())),
        world.holder(name),
        OptionalDouble.empty(),
        Optional.empty());
  }

  private TrueThing lamp(String name) {
    return new TrueThing(
        name,
        Optional.empty(),
        Optional.empty(),
        OptionalDouble.of(world.lampLevel(name)),
        Optional.empty());
  }

  private TrueThing door(String name) {
    return new TrueThing(
        name,
        Optional.empty(),
        Optional.empty(),
        OptionalDouble.empty(),
        Optional.of(world.isOpen(name)));
  }
}
