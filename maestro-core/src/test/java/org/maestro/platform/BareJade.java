package org.maestro.platform;

import jade.wrapper.AgentContainer;
import jade.wrapper.AgentController;
import java.nio.file.Path;
import java.util.Optional;
import org.maestro.agents.MaestroAgent;

/** JADE as the platform starts it, for tests of single agents. */
public final class BareJade implements AutoCloseable {
  private final String name;
  private final Path files;
  private final int port;
  private final AgentContainer main;

  public BareJade(String name, Path files) {
    this.name = name;
    this.files = files;
    this.port = JadeRuntime.claim(0);
    this.main = JadeRuntime.main(name, port, files);
  }

  public AgentContainer main() {
    return main;
  }

  public AgentContainer join(String container) {
    return JadeRuntime.join(Optional.of(name), "127.0.0.1", port, container, files);
  }

  public static AgentController start(AgentContainer container, String name, MaestroAgent agent) {
    return JadeRuntime.start(container, name, agent);
  }

  @Override
  public void close() {
    JadeRuntime.end(main);
  }
}
