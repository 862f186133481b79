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
 * @param brokerPort of one of our own, 0 for a free one
 * @param jadePort of the main container, 0 for a free one
 * @param storyDirectory where stories are kept
 * @param dataDirectory where goals and what was known of the past are kept, to be taken up after a
 *     restart; empty: they end with the site
 * @param allocation what plans are to be best in
 * @param physics of the simulated world
 * @param security the files of a secured site; empty: anybody on the broker is believed
 * @param store where the dataset of the collective knowledge is kept
 * @param premises where the process of the platform can be reached
 * @param homeFile whose permissions are read anew when it changes; empty: they stay as they are
 */
public record SiteSettings(
    String name,
    Home home,
    Optional<Scene> scene,
    long seed,
    Optional<URI> broker,
    int brokerPort,
    int jadePort,
    boolean gui,
    Optional<Path> storyDirectory,
    Optional<Path> dataDirectory,
    Objective allocation,
    PhysicalParameters physics,
    Optional<SiteSecurity> security,
    Store store,
    Premises premises,
    Optional<Path> homeFile) {

  /** Of a site without simulated devices, on a bus of its own, that remembers nothing. */
  public static Builder of(String name, Home home) {
    return new Builder(name, home);
  }

  /** The same, but for what the builder is told. */
  public Builder but() {
    Builder builder = new Builder(name, home);
    builder.scene = scene;
    builder.seed = seed;
    builder.broker = broker;
    builder.brokerPort = brokerPort;
    builder.jadePort = jadePort;
    builder.gui = gui;
    builder.storyDirectory = storyDirectory;
    builder.dataDirectory = dataDirectory;
    builder.allocation = allocation;
    builder.physics = physics;
    builder.security = security;
    builder.store = store;
    builder.premises = premises;
    builder.homeFile = homeFile;
    return builder;
  }

  /** Settings in the making: as usual, until it is said otherwise. For one thread. */
  public static final class Builder {

    private final String name;
    private final Home home;
    private Optional<Scene> scene = Optional.empty();
    private long seed = 1;
    private Optional<URI> broker = Optional.empty();
    private int brokerPort;
    private int jadePort;
    private boolean gui;
    private Optional<Path> storyDirectory = Optional.empty();
    private Optional<Path> dataDirectory = Optional.empty();
    private Objective allocation = Objective.CHEAPEST;
    private PhysicalParameters physics = PhysicalParameters.standard();
    private Optional<SiteSecurity> security = Optional.empty();
    private Store store = Store.IN_MEMORY;
    private Premises premises = Premises.usual();
    private Optional<Path> homeFile = Optional.empty();

    private Builder(String name, Home home) {
      this.name = name;
      this.home = home;
    }

    public Builder scene(Scene scene) {
      this.scene = Optional.of(scene);
      return this;
    }

    public Builder seed(long seed) {
      this.seed = seed;
      return this;
    }

    public Builder broker(URI broker) {
      return broker(Optional.of(broker));
    }

    public Builder broker(Optional<URI> broker) {
      this.broker = broker;
      return this;
    }

    public Builder brokerPort(int brokerPort) {
      this.brokerPort = brokerPort;
      return this;
    }

    public Builder jadePort(int jadePort) {
      this.jadePort = jadePort;
      return this;
    }

    public Builder gui(boolean gui) {
      this.gui = gui;
      return this;
    }

    public Builder storyDirectory(Path storyDirectory) {
      this.storyDirectory = Optional.of(storyDirectory);
      return this;
    }

    public Builder dataDirectory(Path dataDirectory) {
      this.dataDirectory = Optional.of(dataDirectory);
      return this;
    }

    public Builder allocation(Objective allocation) {
      this.allocation = allocation;
      return this;
    }

    public Builder physics(PhysicalParameters physics) {
      this.physics = physics;
      return this;
    }

    public Builder security(SiteSecurity security) {
      this.security = Optional.of(security);
      return this;
    }

    public Builder store(Store store) {
      this.store = store;
      return this;
    }

    public Builder premises(Premises premises) {
      this.premises = premises;
      return this;
    }

    public Builder homeFile(Path homeFile) {
      this.homeFile = Optional.of(homeFile);
      return this;
    }

    public SiteSettings build() {
      return new SiteSettings(
          name,
          home,
          scene,
          seed,
          broker,
          brokerPort,
          jadePort,
          gui,
          storyDirectory,
          dataDirectory,
          allocation,
          physics,
          security,
          store,
          premises,
          homeFile);
    }
  }
}
