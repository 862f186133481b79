package org.maestro.experiment.running;

import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.planning.Objective;
import org.maestro.sim.PhysicalParameters;
import org.maestro.sim.Scene;

/**
 * What one run is made from.
 *
 * @param name of the platform; another for each run of a process
 * @param seed of all chance in the world
 * @param allocation what plans are to be best in
 * @param pace simulated seconds per second of wall time, over MQTT; empty: stepped, within the
 *     process
 */
public record Trial(
    String name,
    Home home,
    Scene scene,
    long seed,
    PhysicalParameters physics,
    Objective allocation,
    OptionalDouble pace) {

  /** On the stepped clock: the same trial gives the same run. */
  public Trial(String name, Home home, Scene scene, long seed, PhysicalParameters physics) {
    this(name, home, scene, seed, physics, Objective.CHEAPEST, OptionalDouble.empty());
  }

  LocalSite open() {
    SiteSettings settings =
        new SiteSettings(
                name, home, Optional.of(scene), seed, Optional.empty(), 0, false, Optional.empty())
            .with(physics)
            .withAllocation(allocation);
    return pace.isPresent()
        ? LocalSite.paced(settings, pace.getAsDouble())
        : LocalSite.stepped(settings);
  }
}
