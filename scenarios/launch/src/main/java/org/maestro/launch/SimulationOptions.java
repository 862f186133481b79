package org.maestro.launch;

import java.nio.file.Path;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** The home and its simulated world, as several commands take them. */
final class SimulationOptions {

  @Parameters(
      paramLabel = "HOME.ttl",
      completionCandidates = Shipped.Homes.class,
      description = "A home file, or a shipped home: bob, arena.")
  private String home;

  @Option(
      names = "--scene",
      paramLabel = "S.ttl",
      completionCandidates = Shipped.Scenes.class,
      description = "Ground truth of the simulated world: a file, or a shipped scene.")
  private Optional<String> scene;

  @Option(
      names = "--speed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Simulated seconds per second; default ${DEFAULT-VALUE}.")
  private double speed;

  @Option(
      names = "--seed",
      paramLabel = "N",
      defaultValue = "1",
      description = "Of all chance in the world; default ${DEFAULT-VALUE}.")
  private long seed;

  Home home() {
    return Shipped.home(home);
  }

  /** The file of the home; empty: it is a shipped one. */
  Optional<Path> homeFile() {
    return Shipped.isShipped(home) ? Optional.empty() : Optional.of(Path.of(home));
  }

  boolean namesScene() {
    return scene.isPresent();
  }

  /**
   * The scene that is named, or the usual one of a shipped home.
   *
   * @param advice what to do where there is none, a sentence
   */
  Scene scene(Home loaded, String advice) {
    return Shipped.scene(
        scene
            .or(() -> Shipped.usualScene(home))
            .orElseThrow(() -> CommandException.badInput(advice)),
        loaded);
  }

  /** Simulated seconds per second, as required of a clock. */
  double speed() {
    Speed.require(speed);
    return speed;
  }

  long seed() {
    return seed;
  }
}
