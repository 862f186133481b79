package org.maestro.platform.threads;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Stream;
import org.maestro.agents.DeskAgent;
import org.maestro.agents.GenericAgent;
import org.maestro.agents.device.Surroundings;
import org.maestro.agents.runtime.AgentTime;
import org.maestro.deployment.AgentStart;
import org.maestro.platform.BareJade;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.time.PacedClock;

/** Starts agents and says what threads they run on; also a program, for another Java. */
final class ThreadProbe {
  private static final int AGENTS = 300;

  private ThreadProbe() {}

  /** Prints one line, and leaves nothing behind. */
  public static void main(String[] arguments) {
    Path files = directory();
    try {
      System.out.println(kinds(files));
      System.out.flush();
    } finally {
      delete(files);
    }
    // A platform that ends with its JVM waits for its agents, some of which JADE may not wake.
    Runtime.getRuntime().halt(0);
  }

  /**
   * What the threads of generic agents, and of the desk, are.
   *
   * @return such as {@code 300 generic agents VIRTUAL, desk PLATFORM}
   */
  static String kinds(Path files) {
    AtomicReference<Thread> ofGeneric = new AtomicReference<>();
    try (BareJade jade = new BareJade("threads", files);
        PacedClock clock = new PacedClock(1)) {
      Surroundings here =
          new Surroundings(
              AgentTime.of(clock),
              link(() -> ofGeneric.set(Thread.currentThread())),
              (description, member) -> {
                throw new IllegalArgumentException("Nobody describes anything here.");
              });
      // More than a Java would carry that holds on to a thread for each who waits.
      for (int number = 0; number < AGENTS; number++) {
        BareJade.start(
            jade.main(),
            "agent-" + number,
            new GenericAgent(jade.birth(), here, AgentStart.of("agent-" + number, "topic")));
      }
      DeskAgent desk = new DeskAgent(jade.birth(), AgentTime.of(clock));
      BareJade.start(jade.main(), "desk", desk);
      AtomicReference<Thread> ofDesk = new AtomicReference<>();
      CountDownLatch told = new CountDownLatch(1);
      desk.tell(
          () -> {
            ofDesk.set(Thread.currentThread());
            told.countDown();
          });
      told.await();
      return "%d generic agents %s, desk %s"
          .formatted(AGENTS, kind(ofGeneric.get()), kind(ofDesk.get()));
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException("Interrupted while agents started.", e);
    }
  }

  /** Java 17 cannot ask; the group of virtual threads has this name. */
  private static AgentThreads kind(Thread thread) {
    return thread.getThreadGroup() != null
            && thread.getThreadGroup().getName().equals("VirtualThreads")
        ? AgentThreads.VIRTUAL
        : AgentThreads.PLATFORM;
  }

  /** Agents watch it as they begin, on their own threads. */
  private static RatsLink link(Runnable watched) {
    return (RatsLink)
        Proxy.newProxyInstance(
            ThreadProbe.class.getClassLoader(),
            new Class<?>[] {RatsLink.class},
            (proxy, method, arguments) -> {
              if (method.getName().equals("watch")) {
                watched.run();
                return (Runnable) () -> {};
              }
              return "probe";
            });
  }

  private static Path directory() {
    try {
      return Files.createTempDirectory("maestro-threads");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void delete(Path directory) {
    List<Path> all = new ArrayList<>();
    try (Stream<Path> files = Files.walk(directory)) {
      files.sorted(Comparator.reverseOrder()).forEach(all::add);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    all.forEach(file -> file.toFile().delete());
  }
}
