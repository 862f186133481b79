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
    Premises premises) {

  /** Of a platform whose agents wait for each other as long as usual. */
  public PlatformSettings(
      String name,
      int port,
      boolean gui,
      Optional<String> brokerUri,
      String site,
      Duration decisionTime,
      Optional<Path> storyDirectory,
      Optional<Path> dataDirectory) {
    this(
        name,
        port,
        gui,
        brokerUri,
        site,
        decisionTime,
        storyDirectory,
        dataDirectory,
        ProtocolTimeouts.standard(),
        Optional.empty(),
        HeartbeatSettings.standard(),
        Premises.usual());
  }

  /** Of a platform that is guarded. */
  public PlatformSettings with(Optional<Guard> other) {
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
        other,
        heartbeats,
        premises);
  }

  /** Of a platform whose containers are given up sooner or later than usual. */
  public PlatformSettings with(HeartbeatSettings other) {
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
        other,
        premises);
  }

  /** Of a platform that can be reached elsewhere. */
  public PlatformSettings at(Premises other) {
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
        other);
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
    return new PlatformSettings(
        name,
        own,
        gui,
        brokerUri,
        site,
        decisionTime,
        storyDirectory,
        dataDirectory,
        patience,
        guard,
        heartbeats,
        premises.with(
            premises
                .letters()
                .map(
                    box ->
                        new Premises.LetterBox(
                            box.host(), Sockets.claim(box.host(), box.port(), "--mtp")))));
  }

  /** Of a platform whose goals end with it. */
  public PlatformSettings(
      String name,
      int port,
      boolean gui,
      Optional<String> brokerUri,
      String site,
      Duration decisionTime,
      Optional<Path> storyDirectory) {
    this(name, port, gui, brokerUri, site, decisionTime, storyDirectory, Optional.empty());
  }
}
