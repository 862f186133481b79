package org.maestro.platform.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.Agent;
import jade.wrapper.AgentContainer;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.device.Host;

/**
 * How containers end that JADE does not end at the first time (Three-layered architecture, 3.3.1;
 * M64).
 */
class ContainerEndsTest {
  private static final String PLATFORM = "container-ends";
  private static final String NAME = "lights";

  /**
   * JADE stumbles over an agent that was never started, such as one that a platform which was only
   * half there did not take in. It takes JADE three seconds.
   */
  @Test
  @Tag("full")
  void aContainerThatJadeLeavesHalfEndedIsEndedAndItsNameIsFree(@TempDir Path files)
      throws Exception {
    Host host = new Host();
    int port = Sockets.claim(0);
    AgentContainer main =
        JadeRuntime.main(
            PLATFORM, port, files, host, Optional.empty(), SharedParts.fresh(), Premises.usual());
    try {
      AgentContainer container =
          JadeRuntime.join(
              Optional.of(PLATFORM),
              "127.0.0.1",
              port,
              NAME,
              files,
              new JadeRuntime.Entry(Optional.empty(), false));
      container.acceptNewAgent("lamp", new Agent());
      AgentsByName jade = new AgentsByName(PLATFORM, host, name -> false);
      assertThat(host.keeps(NAME)).isTrue();

      ContainerEnds.endNow(container);

      assertThat(jade.awaitEnd(NAME)).isTrue();
      assertThat(host.keeps(NAME)).isFalse();
    } finally {
      ContainerEnds.end(main);
    }
  }
}
