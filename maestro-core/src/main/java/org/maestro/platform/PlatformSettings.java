package org.maestro.platform;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import org.maestro.agents.pulse.HeartbeatSettings;
import org.maestro.agents.runtime.ProtocolTimeouts;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.jade.Premises;
import org.maestro.platform.jade.Sockets;

/**
 * The configuration with which a platform is to run.
 *
 * @param name the JADE platform's name
 * @param port of the main container; 0 for a free one
 * @param gui whether to show the JADE remote monitoring agent
 * @param brokerUri of the bus, told to containers that join; empty when the bus lives in this
 *     process
 * @param site on the bus
 * @param decisionTime simulated time that a decision takes; zero on a paced clock
 * @param storyDirectory where stories are kept for {@code why}; empty: only in memory
 * @param dataDirectory where the journal of goals is kept, from which the next platform goes on
 *     after this one's death; empty: goals end with the platform
 * @param patience of the agents with each other
 * @param guard of a secured site; empty: whoever reaches the port may join and speak as anybody
 * @param heartbeats when containers and agents are suspected and given up
 * @param premises where its process can be reached
 * @param homeFile whose permissions are read anew when it changes; empty: they stay as they are
 */
public record PlatformSettings(
    String name,
    int port,
    boolean gui,
    Optional<String> brokerUri,
    String site,
    Duration decisionTime,
    Optional<Path> storyDirectory,
    Optional<Path> dataDirectory,
    ProtocolTimeouts patience,
    Optional<Guard> guard,
    HeartbeatSettings heartbeats,
    Premises premises,
    Optional<Path> homeFile) {

  /** Of a platform whose goals end with it, at the site of its own name. */
  public static Builder of(String name) {
    return new Builder(name);
  }

  /** The same, but for what the builder is told. */
  public Builder but() {
    Builder builder = new Builder(name);
    builder.port = port;
    builder.gui = gui;
    builder.brokerUri = brokerUri;
    builder.site = site;
    builder.decisionTime = decisionTime;
    builder.storyDirectory = storyDirectory;
    builder.dataDirectory = dataDirectory;
    builder.patience = patience;
    builder.guard = guard;
    builder.heartbeats = heartbeats;
    builder.premises = premises;
    builder.homeFile = homeFile;
    return builder;
  }

  /**
   * The same, with ports of its own where any free one is wanted. What speaks to agents of other
   * platforms has one apart.
   *
   * @throws PlatformStartException when one is taken, or a secured site is to hear other platforms
   */
  PlatformSettings claimed() {
    int own = Sockets.claim(premises.host(), port, "--port");
    if (premises.letters().isPresent() && guard.isPresent()) {
      throw new PlatformStartException(
          "A secured site hears nobody whose messages its own processes have not signed, so it has"
              + " no --mtp; leave that away, or have the other platform's people join as guests"
              + " (./maestro secure --guest).");
    }
    return but()
        .port(own)
        .premises(
            premises.with(
                premises
                    .letters()
                    .map(
                        box ->
                            new Premises.LetterBox(
                                box.host(), Sockets.claim(box.host(), box.port(), "--mtp")))))
        .build();
  }

  /** Settings in the making: as usual, until it is said otherwise. For one thread. */
  public static final class Builder {

    private final String name;
    private int port;
    private boolean gui;
    private Optional<String> brokerUri = Optional.empty();
    private String site;
    private Duration decisionTime = Duration.ZERO;
    private Optional<Path> storyDirectory = Optional.empty();
    private Optional<Path> dataDirectory = Optional.empty();
    private ProtocolTimeouts patience = ProtocolTimeouts.standard();
    private Optional<Guard> guard = Optional.empty();
    private HeartbeatSettings heartbeats = HeartbeatSettings.standard();
    private Premises premises = Premises.usual();
    private Optional<Path> homeFile = Optional.empty();

    private Builder(String name) {
      this.name = name;
      this.site = name;
    }

    public Builder port(int port) {
      this.port = port;
      return this;
    }

    public Builder gui(boolean gui) {
      this.gui = gui;
      return this;
    }

    public Builder brokerUri(Optional<String> brokerUri) {
      this.brokerUri = brokerUri;
      return this;
    }

    public Builder site(String site) {
      this.site = site;
      return this;
    }

    public Builder decisionTime(Duration decisionTime) {
      this.decisionTime = decisionTime;
      return this;
    }

    public Builder storyDirectory(Optional<Path> storyDirectory) {
      this.storyDirectory = storyDirectory;
      return this;
    }

    public Builder dataDirectory(Optional<Path> dataDirectory) {
      this.dataDirectory = dataDirectory;
      return this;
    }

    public Builder patience(ProtocolTimeouts patience) {
      this.patience = patience;
      return this;
    }

    public Builder guard(Optional<Guard> guard) {
      this.guard = guard;
      return this;
    }

    public Builder heartbeats(HeartbeatSettings heartbeats) {
      this.heartbeats = heartbeats;
      return this;
    }

    public Builder premises(Premises premises) {
      this.premises = premises;
      return this;
    }

    public Builder homeFile(Optional<Path> homeFile) {
      this.homeFile = homeFile;
      return this;
    }

    public PlatformSettings build() {
      return new PlatformSettings(
          name,
          port,
          gui,
          brokerUri,
          site,
          decisionTime,
          storyDirectory,
          dataDirectory,
          patience,
          guard,
          heartbeats,
          premises,
          homeFile);
    }
  }
}
