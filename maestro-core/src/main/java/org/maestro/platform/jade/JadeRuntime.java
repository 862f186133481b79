package org.maestro.platform.jade;

import jade.core.Profile;
import jade.core.Runtime;
import jade.util.leap.Properties;
import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import jade.wrapper.StaleProxyException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.maestro.agents.device.Host;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.guard.GuardedProfile;
import org.maestro.platform.wires.WiredProfile;
import org.maestro.platform.wires.Wires;

/** Starts JADE containers, and agents in them. */
public final class JadeRuntime {
  /** How many entries the yellow pages tell at most, a hundred if nothing is said. */
  private static final String MOST_FOUND = "jade_domain_df_maxresult";

  private static final int MOST_BEGINNINGS = 10;
  private static final int MOST_MAINS = 10;
  private static final Duration BETWEEN_BEGINNINGS = Duration.ofMillis(100);

  /** JADE lets go of what a container listened with a second after its end. */
  private static final Duration LETTING_GO = Duration.ofMillis(1_200);

  private static final String LOOPBACK = Premises.LOOPBACK;

  /** JADE has it for the whole process, so there is one. */
  static final SharedJade PROCESS = new SharedJade();

  private static final Duration START_WITHIN = Duration.ofSeconds(20);

  private JadeRuntime() {}

  public static AgentContainer main(String platformName, int port, Path fileDirectory) {
    return main(platformName, port, fileDirectory, Optional.empty());
  }

  /** A main container that takes no generic agents. */
  public static AgentContainer main(
      String platformName, int port, Path fileDirectory, Optional<Guard> guard) {
    return main(
        platformName,
        port,
        fileDirectory,
        new Host(),
        guard,
        SharedParts.fresh(),
        Premises.usual());
  }

  /**
   * @param host what the container gives to its agents
   * @param guard of a secured site; empty: whoever reaches the port may join
   * @param shared by the platform's containers of this process
   * @param premises where it listens, without ports that are still to be chosen
   */
  public static AgentContainer main(
      String platformName,
      int port,
      Path fileDirectory,
      Host host,
      Optional<Guard> guard,
      SharedParts shared,
      Premises premises) {
    // JADE reads it when its first class loads; without it a process has room for one platform
    // only.
    System.setProperty("jade.enable.multiple.platforms", "true");
    Properties properties = ContainerProfile.common(fileDirectory, host, premises.host(), shared);
    premises.letters().ifPresent(box -> ContainerProfile.exchange(properties, box));
    properties.setProperty(Profile.MAIN, "true");
    properties.setProperty(Profile.PLATFORM_ID, platformName);
    properties.setProperty(Profile.MAIN_PORT, String.valueOf(port));
    properties.setProperty(Profile.MAIN_HOST, premises.host());
    properties.setProperty(MOST_FOUND, String.valueOf(Integer.MAX_VALUE));
    guard.ifPresent(own -> GuardedProfile.guard(properties, own));
    ContainerProfile.listen(properties, guard, port);
    Optional<AgentContainer> container = Optional.empty();
    // JADE's connections are those of all platforms of one name in this process, and end with the
    // last: a platform of the same name that begins at that moment finds none, and begins again.
    boolean isFree = true;
    for (int attempt = 1; container.isEmpty() && attempt <= MOST_MAINS; attempt++) {
      if (attempt > 1) {
        LockSupport.parkNanos(BETWEEN_BEGINNINGS.toNanos());
        isFree = Sockets.isFree(premises.host(), port);
      }
      if (isFree) {
        container =
            begun(
                () -> shared.wires().beforeOthers(() -> mainContainer(properties, shared.wires())));
        if (container.isPresent() && Sockets.isFree(premises.host(), port)) {
          // They ended after this one had taken them up, and before JADE had noted that.
          ContainerEnds.endNow(container.get());
          LockSupport.parkNanos(LETTING_GO.toNanos());
          container = Optional.empty();
        }
      }
    }
    String problem =
        isFree
            ? "JADE could not start, though its port " + port + " is free; the log says why."
            : "Port " + port + " was taken just now; choose another with --port.";
    return container.orElseThrow(() -> new PlatformStartException(problem));
  }

  private static AgentContainer mainContainer(Properties properties, Wires wires) {
    return Runtime.instance().createMainContainer(new WiredProfile(properties, wires));
  }

  /** Joins with a container that takes no generic agents. */
  public static AgentContainer join(
      Optional<String> platformName,
      String host,
      int mainPort,
      String containerName,
      Path fileDirectory,
      Entry entry) {
    return join(
        platformName,
        host,
        mainPort,
        containerName,
        fileDirectory,
        entry,
        new Host(),
        SharedParts.fresh());
  }

  /**
   * Joins a platform.
   *
   * @param platformName needed where several platforms live in this process; elsewhere the main
   *     container tells it
   * @param entry how it is let in
   * @param jadeHost what the container gives to its agents
   * @param shared by the platform's containers of this process
   */
  public static AgentContainer join(
      Optional<String> platformName,
      String host,
      int mainPort,
      String containerName,
      Path fileDirectory,
      Entry entry,
      Host jadeHost,
      SharedParts shared) {
    Properties properties = ContainerProfile.common(fileDirectory, jadeHost, entry.from(), shared);
    properties.setProperty(Profile.MAIN, "false");
    platformName.ifPresent(name -> properties.setProperty(Profile.PLATFORM_ID, name));
    properties.setProperty(Profile.MAIN_HOST, host);
    properties.setProperty(Profile.MAIN_PORT, String.valueOf(mainPort));
    properties.setProperty(Profile.CONTAINER_NAME, containerName);
    entry.guard().ifPresent(own -> GuardedProfile.guard(properties, own));
    Supplier<AgentContainer> joining =
        () -> Runtime.instance().createAgentContainer(new WiredProfile(properties, shared.wires()));
    Optional<AgentContainer> joined =
        entry.first()
            ? listening(properties, entry, joining)
            : begun(joining).or(() -> listening(properties, entry, joining));
    return joined.orElseThrow(
        () ->
            new PlatformStartException(
                "The container %s could not join the platform at %s:%d; its log says why."
                    .formatted(containerName, host, mainPort)));
  }

  /**
   * Joins with connections of its own: those that the platform's containers of this process share
   * JADE forgets when an earlier platform of that name ends late. A port that was free a moment ago
   * may be taken by then; then another one is.
   */
  private static Optional<AgentContainer> listening(
      Properties properties, Entry entry, Supplier<AgentContainer> joining) {
    for (int attempt = 1; ; attempt++) {
      int port = Sockets.free(entry.from());
      ContainerProfile.listen(properties, entry.guard(), port);
      Optional<AgentContainer> joined = begun(joining);
      if (joined.isPresent() || attempt == MOST_BEGINNINGS || Sockets.isFree(entry.from(), port)) {
        return joined;
      }
    }
  }

  /**
   * What JADE has for a whole process ends with its last container, in a thread of its own; a
   * container that begins just then finds its threads' group gone, and is begun once more.
   *
   * @return the container; empty when JADE could not begin it
   */
  private static Optional<AgentContainer> begun(Supplier<AgentContainer> beginning) {
    return PROCESS.begin(() -> begunAtLast(beginning));
  }

  private static Optional<AgentContainer> begunAtLast(Supplier<AgentContainer> beginning) {
    for (int attempt = 1; ; attempt++) {
      try {
        return Optional.ofNullable(beginning.get());
      } catch (IllegalThreadStateException e) {
        if (attempt == MOST_BEGINNINGS) {
          throw new PlatformStartException(
              "JADE could not begin a container while another of this process ended; start it"
                  + " again.",
              e);
        }
        LockSupport.parkNanos(BETWEEN_BEGINNINGS.toNanos());
      }
    }
  }

  /**
   * The way of a container into a platform.
   *
   * @param guard of a secured site; empty on an open one
   * @param first whether no other container of the platform is in this process: it listens for all
   * @param from the address of this machine on which the first one listens for other containers
   */
  public record Entry(Optional<Guard> guard, boolean first, String from) {
    public static final Entry OPEN = new Entry(Optional.empty(), true, LOOPBACK);

    /** From this machine. */
    public Entry(Optional<Guard> guard, boolean first) {
      this(guard, first, LOOPBACK);
    }
  }

  /**
   * Shows JADE's own windows: its remote management agent begins in the main container.
   *
   * @throws PlatformStartException when it cannot begin
   */
  public static void showGui(AgentContainer main) {
    try {
      main.createNewAgent("rma", "jade.tools.rma.rma", new Object[0]).start();
    } catch (StaleProxyException e) {
      throw new PlatformStartException("The JADE GUI could not start.", e);
    }
  }

  /**
   * Starts the agent and waits until it has set itself up, so that agents start one after the
   * other.
   */
  public static AgentController start(AgentContainer container, String name, MaestroAgent agent) {
    try {
      AgentController controller = container.acceptNewAgent(name, agent);
      controller.start();
      if (!agent.awaitStart(START_WITHIN)) {
        throw new PlatformStartException(
            "The agent %s was not ready within %d s; the log says why."
                .formatted(name, START_WITHIN.toSeconds()));
      }
      return controller;
    } catch (StaleProxyException e) {
      throw new PlatformStartException(
          "The agent %s could not start; is there another of that name?".formatted(name), e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new PlatformStartException("Interrupted while the agent " + name + " started.", e);
    }
  }

  /**
   * Finds out in bounded time whether a platform listens there, which JADE itself does not.
   *
   * @return the address of this machine from which it was reached
   * @throws PlatformStartException when none does, or it lets nobody of this process in
   */
  public static String requirePlatform(String host, int mainPort, Optional<Guard> guard) {
    guard
        .flatMap(own -> own.objection(host, mainPort))
        .ifPresent(
            objection -> {
              throw new PlatformStartException(objection);
            });
    return Sockets.addressTowards(host, mainPort)
        .orElseThrow(
            () ->
                new PlatformStartException(
                    "No platform answers at %s:%d; start one with ./maestro run, or name another with --main HOST:PORT."
                        .formatted(host, mainPort)));
  }
}
