package org.maestro.experiment.running;

import java.util.OptionalDouble;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.planning.api.Objective;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;

/**
 * The home, scene, seed and settings of one run.
 *
 * @param name that the platform's begins with
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
        SiteSettings.of(nameOfItsOwn(), home)
            .scene(scene)
            .seed(seed)
            .allocation(allocation)
            .physics(physics)
            .build();
    return pace.isPresent()
        ? LocalSite.paced(settings, pace.getAsDouble())
        : LocalSite.stepped(settings);
  }

  /** A platform ends some seconds after its site is closed; until then its name is taken. */
  private String nameOfItsOwn() {
    return name + "-" + Long.toString(System.nanoTime(), Character.MAX_RADIX);
  }
}
