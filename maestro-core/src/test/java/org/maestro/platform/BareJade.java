package org.maestro.platform;

import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.awaitility.Awaitility;
import org.maestro.agents.runtime.Birth;
import org.maestro.agents.runtime.MaestroAgent;
import org.maestro.platform.guard.Guard;
import org.maestro.platform.jade.ContainerEnds;
import org.maestro.platform.jade.JadeRuntime;
import org.maestro.platform.jade.Sockets;

/** JADE as the platform starts it, for tests of single agents. */
public final class BareJade implements AutoCloseable {
  private final String name;
  private final Path files;
  private final int port;
  private final AgentContainer main;

  public BareJade(String name, Path files) {
    this(name, files, Optional.empty());
  }

  public BareJade(String name, Path files, Optional<Guard> guard) {
    this.name = name;
    this.files = files;
    this.port = Sockets.claim(0);
    this.main = JadeRuntime.main(name, port, files, guard);
    // Its first agent writes that in its own time, which may be after a short test has ended.
    Awaitility.await().until(() -> Files.exists(files.resolve("APDescription.txt")));
  }

  public int port() {
    return port;
  }

  public AgentContainer main() {
    return main;
  }

  public AgentContainer join(String container) {
    return join(container, Optional.empty());
  }

  /** Within this process, so that it needs no connection of its own. */
  public AgentContainer join(String container, Optional<Guard> guard) {
    return JadeRuntime.join(
        Optional.of(name),
        "127.0.0.1",
        port,
        container,
        files,
        new JadeRuntime.Entry(guard, false));
  }

  /** Where JADE writes. */
  public Path files() {
    return files;
  }

  /** Of one agent. */
  public Birth birth() {
    return Birth.of(main);
  }

  public static AgentController start(AgentContainer container, String name, MaestroAgent agent) {
    return JadeRuntime.start(container, name, agent);
  }

  @Override
  public void close() {
    ContainerEnds.end(main);
  }
}
