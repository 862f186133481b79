package org.maestro.assembly;

import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.sim.Scene;

/**
 * How a site is to run.
 *
 * @param name of the JADE platform, and of the site on the bus
 * @param scene ground truth of the simulated world; empty: no simulated devices
 * @param seed of all chance in the world
 * @param broker of the bus; empty: one of our own in this process
 * @param jadePort of the main container on loopback, 0 for a free one
 * @param storyDirectory where stories are kept
 */
public record SiteSettings(
    String name,
    Home home,
    Optional<Scene> scene,
    long seed,
    Optional<URI> broker,
    int jadePort,
    boolean gui,
    Optional<Path> storyDirectory) {}
