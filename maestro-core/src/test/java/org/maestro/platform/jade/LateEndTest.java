package org.maestro.platform.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.wrapper.AgentContainer;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.platform.jade.JadeRuntime.Entry;

/** A platform of a name that ends when another of that name has begun in the same process. */
class LateEndTest {
  private static final String NAME = "late-end";

  @Test
  void whoJoinsAfterJadeHasForgottenTheConnectionsHasItsOwn(@TempDir Path files) throws Exception {
    int port = Sockets.claim(0);
    AgentContainer main = JadeRuntime.main(NAME, port, files);
    forgetConnections();

    AgentContainer joined =
        JadeRuntime.join(
            Optional.of(NAME),
            Premises.LOOPBACK,
            port,
            "cameras",
            files,
            new Entry(Optional.empty(), false));

    assertThat(joined.isJoined()).isTrue();
    ContainerEnds.endNow(joined);
    ContainerEnds.endNow(main);
  }

  /** What JADE does at the end of a platform of that name. */
  private static void forgetConnections() throws ReflectiveOperationException {
    Method forget =
        Class.forName("jade.imtp.leap.CommandDispatcher")
            .getDeclaredMethod("removeDispatcher", String.class);
    forget.setAccessible(true);
    forget.invoke(null, NAME);
  }
}
