package org.maestro.platform;

import jade.core.Profile;
import jade.core.Runtime;
import jade.util.leap.Properties;
import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import jade.wrapper.StaleProxyException;
import java.io.File;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.NetworkInterface;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ThreadLocalRandom;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.maestro.agents.Host;
import org.maestro.agents.HostService;
import org.maestro.agents.MaestroAgent;
import org.maestro.agents.pulse.ProcessPulse;
import org.maestro.agents.pulse.PulseService;
import org.maestro.agents.stepping.SteppedMailService;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.guard.SerialFilter;
import org.maestro.platform.letters.BoundedLetters;
import org.maestro.platform.letters.EnvelopeReader;
import org.maestro.platform.threads.AgentThreads;
import org.maestro.platform.wires.WiredProfile;

/**
 * Starts and ends JADE containers with safe defaults: loopback only, no multicast, no MTP, no files
 * in the working directory.
 */
final class JadeRuntime {
  /** How many entries the yellow pages tell at most, a hundred if nothing is said. */
  private static final String MOST_FOUND = "jade_domain_df_maxresult";

  private static final int MOST_BEGINNINGS = 10;
  private static final Duration BETWEEN_BEGINNINGS = Duration.ofMillis(100);

  private static final String LOOPBACK = Premises.LOOPBACK;
  private static final String LETTERS = BoundedLetters.class.getName();

  /** JADE counts its containers without guarding the count. */
  private static final Object ONE_AT_A_TIME = new Object();

  private static final Duration LEAST_AGE = Duration.ofMillis(3_100);
  private static final Duration START_WITHIN = Duration.ofSeconds(20);
  private static final String SERVICES =
      String.join(
          ";",
          "jade.core.mobility.AgentMobilityService",
          "jade.core.event.NotificationService",
          SteppedMailService.class.getName(),
          PulseService.class.getName(),
          HostService.class.getName());

  private static final int LOWEST_PORT = 20_000;
  private static final int HIGHEST_PORT = 32_000;
  private static final int MOST_ATTEMPTS = 1_000;

  private JadeRuntime() {}

  static AgentContainer main(String platformName, int port, Path fileDirectory) {
    return main(platformName, port, fileDirectory, Optional.empty());
  }

  /** A main container that takes no generic agents. */
  static AgentContainer main(
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
  static AgentContainer main(
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
    Properties properties = common(fileDirectory, host, premises.host(), shared);
    premises.letters().ifPresent(box -> exchange(properties, box));
    properties.setProperty(Profile.MAIN, "true");
    properties.setProperty(Profile.PLATFORM_ID, platformName);
    properties.setProperty(Profile.LOCAL_PORT, String.valueOf(port));
    properties.setProperty(Profile.MAIN_PORT, String.valueOf(port));
    properties.setProperty(Profile.MAIN_HOST, premises.host());
    properties.setProperty(MOST_FOUND, String.valueOf(Integer.MAX_VALUE));
    guard.ifPresent(own -> own.guard(properties));
    guard.ifPresent(own -> own.listen(properties));
    AgentContainer container =
        begun(
            () ->
                Runtime.instance()
                    .createMainContainer(new WiredProfile(properties, shared.wires())));
    if (container == null) {
      throw new PlatformStartException(
          "JADE could not start on port " + port + "; choose another with --port.");
    }
    return container;
  }

  /** Joins with a container that takes no generic agents. */
  static AgentContainer join(
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
  static AgentContainer join(
      Optional<String> platformName,
      String host,
      int mainPort,
      String containerName,
      Path fileDirectory,
      Entry entry,
      Host jadeHost,
      SharedParts shared) {
    Properties properties = common(fileDirectory, jadeHost, entry.from(), shared);
    properties.setProperty(Profile.MAIN, "false");
    platformName.ifPresent(name -> properties.setProperty(Profile.PLATFORM_ID, name));
    properties.setProperty(Profile.MAIN_HOST, host);
    properties.setProperty(Profile.MAIN_PORT, String.valueOf(mainPort));
    properties.setProperty(Profile.LOCAL_PORT, String.valueOf(freePort(entry.from())));
    properties.setProperty(Profile.CONTAINER_NAME, containerName);
    entry.guard().ifPresent(own -> own.guard(properties));
    entry.guard().filter(own -> entry.first()).ifPresent(own -> own.listen(properties));
    AgentContainer container =
        begun(
            () ->
                Runtime.instance()
                    .createAgentContainer(new WiredProfile(properties, shared.wires())));
    if (container == null) {
      throw new PlatformStartException(
          "The container %s could not join the platform at %s:%d; its log says why."
              .formatted(containerName, host, mainPort));
    }
    return container;
  }

  /**
   * What JADE has for a whole process ends with its last container, in a thread of its own; a
   * container that begins just then finds its threads' group gone, and is begun once more.
   *
   * @return the container; null when JADE could not begin it
   */
  private static AgentContainer begun(Supplier<AgentContainer> beginning) {
    synchronized (ONE_AT_A_TIME) {
      for (int attempt = 1; ; attempt++) {
        try {
          return beginning.get();
        } catch (IllegalThreadStateException e) {
          if (attempt == MOST_BEGINNINGS) {
            throw new PlatformStartException(
                "JADE could not begin a container while another of this process ended; start it again.",
                e);
          }
          LockSupport.parkNanos(BETWEEN_BEGINNINGS.toNanos());
        }
      }
    }
  }

  /**
   * How a container comes into a platform.
   *
   * @param guard of a secured site; empty on an open one
   * @param first whether no other container of the platform is in this process
   * @param from the address of this machine on which it listens for other containers
   */
  record Entry(Optional<Guard> guard, boolean first, String from) {
    static final Entry OPEN = new Entry(Optional.empty(), true, LOOPBACK);

    /** From this machine. */
    Entry(Optional<Guard> guard, boolean first) {
      this(guard, first, LOOPBACK);
    }
  }

  /**
   * Starts the agent and waits until it has set itself up, so that agents start one after the
   * other.
   */
  static AgentController start(AgentContainer container, String name, MaestroAgent agent) {
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
  static String requirePlatform(String host, int mainPort, Optional<Guard> guard) {
    guard
        .flatMap(own -> own.objection(host, mainPort))
        .ifPresent(
            objection -> {
              throw new PlatformStartException(objection);
            });
    return addressTowards(host, mainPort)
        .orElseThrow(
            () ->
                new PlatformStartException(
                    "No platform answers at %s:%d; start one with ./maestro run, or name another with --main HOST:PORT."
                        .formatted(host, mainPort)));
  }

  /** Ends a container; when it returns the platform knows its name no more. */
  static void endNow(AgentContainer container) {
    kill(container);
  }

  /** Ends a container beside the caller; the threads it leaves are daemons. */
  static void end(AgentContainer container) {
    endBeside(() -> kill(container));
  }

  /**
   * Ends the containers of a platform one after the other beside the caller, the main one last, as
   * the others need it to say goodbye. JADE makes containers younger than three seconds wait for
   * that age.
   *
   * @param sinceNanos when the platform started
   */
  static void end(List<AgentContainer> containers, long sinceNanos) {
    endBeside(
        () -> {
          LockSupport.parkNanos(sinceNanos + LEAST_AGE.toNanos() - System.nanoTime());
          containers.forEach(JadeRuntime::kill);
        });
  }

  /** The same for one that the platform has given up: it may wait for ever, and nobody for it. */
  static void abandon(AgentContainer container) {
    endBeside(
        () -> {
          try {
            container.kill();
          } catch (StaleProxyException e) {
            // It is gone already, which is what was wanted.
          }
        });
  }

  private static void endBeside(Runnable deed) {
    Thread ending = new Thread(deed, "maestro-container-end");
    ending.setDaemon(true);
    ending.start();
  }

  private static void kill(AgentContainer container) {
    synchronized (ONE_AT_A_TIME) {
      try {
        container.kill();
      } catch (StaleProxyException e) {
        // It is gone already, which is what was wanted.
      }
    }
  }

  /** On loopback. */
  static int claim(int port) {
    return claim(LOOPBACK, port, "--port");
  }

  /**
   * The port asked for if it is free, any free one for 0.
   *
   * @param host an address of this machine
   * @param option by which people choose another
   */
  static int claim(String host, int port, String option) {
    requireOwn(host);
    if (port == 0) {
      return freePort(host);
    }
    try (ServerSocket socket = new ServerSocket()) {
      socket.bind(new InetSocketAddress(host, port));
      return port;
    } catch (IOException e) {
      throw new PlatformStartException(
          "Port %d is in use; stop what listens there, or choose another with %s."
              .formatted(port, option),
          e);
    }
  }

  private static void requireOwn(String host) {
    try {
      if (NetworkInterface.getByInetAddress(InetAddress.getByName(host)) != null) {
        return;
      }
    } catch (IOException e) {
      throw notOwn(host);
    }
    throw notOwn(host);
  }

  private static PlatformStartException notOwn(String host) {
    return new PlatformStartException(
        "%s is no address of this machine; name one of its own, or leave it away for %s."
            .formatted(host, LOOPBACK));
  }

  /**
   * Not one of those that the system gives to outgoing connections: among those another may get it
   * before JADE does.
   */
  private static int freePort(String host) {
    for (int attempt = 0; attempt < MOST_ATTEMPTS; attempt++) {
      int port = ThreadLocalRandom.current().nextInt(LOWEST_PORT, HIGHEST_PORT);
      if (isFree(host, port)) {
        return port;
      }
    }
    throw new PlatformStartException("No free port on " + host + ".");
  }

  private static boolean isFree(String host, int port) {
    try (ServerSocket socket = new ServerSocket(port, 1, InetAddress.getByName(host))) {
      return socket.isBound();
    } catch (IOException e) {
      return false;
    }
  }

  private static Optional<String> addressTowards(String host, int port) {
    try (Socket socket = new Socket()) {
      socket.connect(new InetSocketAddress(InetAddress.getByName(host), port), 2_000);
      return Optional.of(socket.getLocalAddress().getHostAddress());
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** Agents of other platforms are heard; what they send is read with care. */
  private static void exchange(Properties properties, Premises.LetterBox box) {
    SerialFilter.install();
    properties.setProperty(Profile.NO_MTP, "false");
    properties.setProperty(Profile.MTPS, LETTERS + "(" + box.url() + ")");
    properties.setProperty("jade_mtp_http_parser", EnvelopeReader.class.getName());
  }

  private static Properties common(Path fileDirectory, Host host, String from, SharedParts shared) {
    Properties properties = new Properties();
    properties.put(ProcessPulse.KEY, shared.pulse());
    properties.put(HostService.KEY, host);
    properties.setProperty(Profile.LOCAL_HOST, from);
    properties.setProperty(Profile.DETECT_MAIN, "false");
    properties.setProperty(Profile.NO_MTP, "true");
    properties.setProperty(Profile.SERVICES, SERVICES);
    properties.setProperty(Profile.FILE_DIR, fileDirectory + File.separator);
    properties.setProperty("jade_imtp_leap_JICP_JICPServer_acceptlocalhostonly", "true");
    properties.setProperty("jade_core_messaging_MessageManager_poolsize", "1");
    properties.setProperty("jade_domain_df_autocleanup", "true");
    properties.setProperty("jade_core_FullResourceManager_disablethreadgroupinterrupt", "true");
    AgentThreads.chosen().of(properties);
    return properties;
  }
}
