package org.maestro.assembly;

import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import org.maestro.knowledge.api.Store;
import org.maestro.ontology.home.Home;
import org.maestro.planning.api.Objective;
import org.maestro.platform.jade.Premises;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.Scene;

/**
 * The settings with which a site runs.
 *
 * @param name of the JADE platform, and of the site on the bus
 * @param scene ground truth of the simulated world; empty: no simulated devices
 * @param seed of all chance in the world
 * @param broker of the bus; empty: one of our own in this process
 * @param jadePort of the main container, 0 for a free one
 * @param storyDirectory where stories are kept
 * @param dataDirectory where goals and what was known of the past are kept, to be taken up after a
 *     restart; empty: they end with the site
 * @param allocation what plans are to be best in
 * @param physics of the simulated world
 * @param security the files of a secured site; empty: anybody on the broker is believed
 * @param store where the dataset of the collective knowledge is kept
 * @param premises where the process of the platform can be reached
 */
public record SiteSettings(
    String name,
    Home home,
    Optional<Scene> scene,
    long seed,
    Optional<URI> broker,
    int jadePort,
    boolean gui,
    Optional<Path> storyDirectory,
    Optional<Path> dataDirectory,
    Objective allocation,
    PhysicalParameters physics,
    Optional<SiteSecurity> security,
    Store store,
    Premises premises) {

  /** Of a site that allocates steps so that they cost least. */
  public SiteSettings(
      String name,
      Home home,
      Optional<Scene> scene,
      long seed,
      Optional<URI> broker,
      int jadePort,
      boolean gui,
      Optional<Path> storyDirectory,
      Optional<Path> dataDirectory) {
    this(
        name,
        home,
        scene,
        seed,
        broker,
        jadePort,
        gui,
        storyDirectory,
        dataDirectory,
        Objective.CHEAPEST,
        PhysicalParameters.standard(),
        Optional.empty(),
        Store.IN_MEMORY,
        Premises.usual());
  }

  public SiteSettings withAllocation(Objective other) {
    return new SiteSettings(
        name,
        home,
        scene,
        seed,
        broker,
        jadePort,
        gui,
        storyDirectory,
        dataDirectory,
        other,
        physics,
        security,
        store,
        premises);
  }

  public SiteSettings withSecurity(Optional<SiteSecurity> files) {
    return new SiteSettings(
        name,
        home,
        scene,
        seed,
        broker,
        jadePort,
        gui,
        storyDirectory,
        dataDirectory,
        allocation,
        physics,
        files,
        store,
        premises);
  }

  /** The same with the dataset of the collective knowledge elsewhere. */
  public SiteSettings withStore(Store other) {
    return new SiteSettings(
        name,
        home,
        scene,
        seed,
        broker,
        jadePort,
        gui,
        storyDirectory,
        dataDirectory,
        allocation,
        physics,
        security,
        other,
        premises);
  }

  /** The same, to be reached elsewhere. */
  public SiteSettings at(Premises other) {
    return new SiteSettings(
        name,
        home,
        scene,
        seed,
        broker,
        jadePort,
        gui,
        storyDirectory,
        dataDirectory,
        allocation,
        physics,
        security,
        store,
        other);
  }

  /** The same in a world of other physics. */
  public SiteSettings with(PhysicalParameters other) {
    return new SiteSettings(
        name,
        home,
        scene,
        seed,
        broker,
        jadePort,
        gui,
        storyDirectory,
        dataDirectory,
        allocation,
        other,
        security,
        store,
        premises);
  }

  /** Of a site that remembers nothing. */
  public SiteSettings(
      String name,
      Home home,
      Optional<Scene> scene,
      long seed,
      Optional<URI> broker,
      int jadePort,
      boolean gui,
      Optional<Path> storyDirectory) {
    this(name, home, scene, seed, broker, jadePort, gui, storyDirectory, Optional.empty());
  }
}
