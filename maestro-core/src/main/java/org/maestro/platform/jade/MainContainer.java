package org.maestro.platform.jade;

import jade.wrapper.AgentContainer;
import jade.wrapper.ControllerException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.agents.device.Host;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.lives.AgentLives;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.deployment.Directory;
import org.maestro.platform.guard.Guard;

/**
 * The main container of a platform in this process, its tables of agents and containers, and the
 * further containers that join it from here. Any thread may use it.
 */
public final class MainContainer {
  private final long sinceNanos = System.nanoTime();
  private final String platform;
  private final int port;
  private final Optional<Guard> guard;
  private final Premises premises;
  private final JadeDirectory files;
  private final Host host;
  private final SharedParts shared;
  private final AgentContainer container;
  private final Directory directory = new Directory();

  private MainContainer(
      String platform,
      int port,
      Optional<Guard> guard,
      Premises premises,
      JadeDirectory files,
      Host host,
      SharedParts shared,
      AgentContainer container) {
    this.platform = platform;
    this.port = port;
    this.guard = guard;
    this.premises = premises;
    this.files = files;
    this.host = host;
    this.shared = shared;
    this.container = container;
  }

  /**
   * Boots it.
   *
   * @param guard of a secured site; empty: whoever reaches the port may join
   * @param premises where it listens, with ports that are chosen
   * @throws PlatformStartException when JADE cannot begin there
   */
  public static MainContainer boot(
      String platform, int port, Optional<Guard> guard, Premises premises) {
    JadeDirectory files = JadeDirectory.fresh();
    Host host = new Host();
    SharedParts shared = SharedParts.fresh();
    AgentContainer container =
        JadeRuntime.main(platform, port, files.path(), host, guard, shared, premises);
    return new MainContainer(platform, port, guard, premises, files, host, shared, container);
  }

  /** From now on its agents find these around them. */
  public void give(Surroundings surroundings) {
    host.give(surroundings);
  }

  /** The tables are kept from now on, and who listens to the agents' lives is told of them. */
  public void watch(Supplier<Instant> now, AgentLives lives) {
    PlatformEvents.watch(host, directory, now, lives);
  }

  /** Joins a further container of this process, which gives this to its agents. */
  public AgentContainer join(String name, Host its) {
    return JadeRuntime.join(
        Optional.of(platform),
        premises.host(),
        port,
        name,
        files.path(),
        new JadeRuntime.Entry(guard, false, premises.host()),
        its,
        shared);
  }

  /** Begins and ends agents of all containers by their names. */
  public AgentsByName agentsByName() {
    return new AgentsByName(platform, host, agent -> directory.find(agent).isPresent());
  }

  /** Attests the birth of an agent of this platform. */
  public Birth birth() {
    return Birth.of(container);
  }

  /** Starts an agent in it; see {@link JadeRuntime#start}. */
  public void start(String name, MaestroAgent agent) {
    JadeRuntime.start(container, name, agent);
  }

  /**
   * Ends an agent of it, as a person does in the JADE GUI.
   *
   * @throws PlatformStartException when there is none of that name
   */
  public void end(String agent) {
    try {
      container.getAgent(agent).kill();
    } catch (ControllerException e) {
      throw new PlatformStartException("There is no agent " + agent + " to end.", e);
    }
  }

  /** See {@link JadeRuntime#showGui}. */
  public void showGui() {
    JadeRuntime.showGui(container);
  }

  /** Where others reach it, {@code host:port}. */
  public String address() {
    return premises.host() + ":" + port;
  }

  /** Where JADE writes its files; it goes with the platform. */
  public Path files() {
    return files.path();
  }

  public SharedParts shared() {
    return shared;
  }

  /** Agents and containers as JADE has them. */
  public Directory directory() {
    return directory;
  }

  /**
   * Ends it beside the caller, after the others, and removes its files.
   *
   * @param others of this process
   */
  public void close(List<AgentContainer> others) {
    ContainerEnds.end(others, container, host, sinceNanos);
    files.close();
  }
}
