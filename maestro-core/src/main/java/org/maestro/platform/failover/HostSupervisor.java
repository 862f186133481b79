package org.maestro.platform.failover;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.maestro.platform.hosts.Backoff;
import org.maestro.platform.hosts.HostStart;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Starts the processes of the hosts that belong to the platform, and starts them again when they
 * have ended, or were given up; the more often that happens, the later (ADE, 3.2; A36). What joins
 * by itself is left in peace. Any thread may call.
 */
public final class HostSupervisor implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(HostSupervisor.class);
  private static final Duration FIRST_DELAY = Duration.ofSeconds(1);
  private static final Duration LONGEST_DELAY = Duration.ofMinutes(1);

  private final Map<String, HostStart> hosts = new LinkedHashMap<>();
  private final Map<String, Process> running = new LinkedHashMap<>();
  private final Backoff backoff = new Backoff(FIRST_DELAY, LONGEST_DELAY);
  private final String main;
  private final Path directory;
  private final Predicate<String> isThere;
  private final long sinceNanos = System.nanoTime();
  private final ScheduledExecutorService soon =
      Executors.newSingleThreadScheduledExecutor(
          work -> {
            Thread thread = new Thread(work, "process-starter");
            thread.setDaemon(true);
            return thread;
          });

  /**
   * @param main {@code HOST:PORT} of the main container
   * @param directory where what the processes print is kept, a file for each
   * @param isThere whether a container of that name has joined
   */
  public HostSupervisor(
      List<HostStart> hosts, String main, Path directory, Predicate<String> isThere) {
    hosts.forEach(host -> this.hosts.put(host.name(), host));
    this.main = main;
    this.directory = directory;
    this.isThere = isThere;
  }

  /**
   * Starts all that are not there by then.
   *
   * @param grace for those that outlived the process whose place this one takes
   */
  public void begin(Duration grace) {
    hosts.values().forEach(host -> later(host, grace));
  }

  /** The container is not there any more. What is left of its process ends first. */
  public synchronized void gone(String name) {
    HostStart host = hosts.get(name);
    if (host == null) {
      return;
    }
    Process left = running.get(name);
    if (left != null && left.isAlive()) {
      // That it has ended is told by its end.
      left.destroyForcibly();
    } else {
      died(host, left);
    }
  }

  private void later(HostStart host, Duration delay) {
    if (!soon.isShutdown()) {
      Future<?> unusedAsCloseEndsThemAll =
          soon.schedule(() -> start(host), delay.toMillis(), TimeUnit.MILLISECONDS);
    }
  }

  private synchronized void start(HostStart host) {
    String name = host.name();
    Process former = running.get(name);
    if (soon.isShutdown() || isThere.test(name) || (former != null && former.isAlive())) {
      return;
    }
    List<String> command = host.command(main);
    File said = directory.resolve(name + ".log").toFile();
    try {
      Process process =
          new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(ProcessBuilder.Redirect.appendTo(said))
              .start();
      process.getOutputStream().close();
      running.put(name, process);
      LOG.info("The process of {} is started: {}", name, String.join(" ", command));
      Future<?> unusedAsDiedSaysAllThereIs =
          process.onExit().thenAccept(ended -> died(host, ended));
    } catch (IOException e) {
      LOG.warn("The process of {} cannot be started: {}", name, e.getMessage());
      died(host, former);
    }
  }

  /** Told once of each process; one that is not the last any more does not count. */
  private synchronized void died(HostStart host, @Nullable Process process) {
    String name = host.name();
    if (soon.isShutdown() || running.get(name) != process) {
      return;
    }
    running.remove(name);
    Duration delay = backoff.died(name, Duration.ofNanos(System.nanoTime() - sinceNanos));
    LOG.warn(
        "The process of {} has ended; it is started again in {} s. What it said is in {}.",
        name,
        delay.toSeconds(),
        directory.resolve(name + ".log"));
    later(host, delay);
  }

  /** The processes that were started here end. */
  @Override
  public void close() {
    List<Process> left;
    synchronized (this) {
      soon.shutdownNow();
      left = new ArrayList<>(running.values());
    }
    left.forEach(Process::destroy);
  }
}
