package org.maestro.agents.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import jade.wrapper.ContainerController;
import java.lang.reflect.Field;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CyclicBarrier;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.platform.BareJade;

/**
 * Agents of a container that come and go at the same moment (Three-layered architecture, 3.3.1;
 * M64).
 */
class AgentTableTest {
  private static final int THREADS = 4;
  private static final int AGENTS = 300_000;

  @Test
  void countsNobodyWhoIsGone() throws Exception {
    AgentTable table = new AgentTable();
    CyclicBarrier together = new CyclicBarrier(THREADS);
    List<Thread> threads =
        IntStream.range(0, THREADS)
            .mapToObj(number -> new Thread(() -> comeAndGo(table, together, number)))
            .toList();
    threads.forEach(Thread::start);
    for (Thread thread : threads) {
      thread.join();
    }

    assertThat(table.size()).isZero();
    assertThat(table.values().toArray()).isEmpty();
  }

  private static void comeAndGo(AgentTable table, CyclicBarrier together, int number) {
    try {
      together.await();
    } catch (Exception e) {
      throw new IllegalStateException(e);
    }
    for (int i = 0; i < AGENTS; i++) {
      String name = number + "-" + i;
      table.put(name, name);
      table.remove(name);
    }
  }

  @Test
  void eachContainerHasOne(@TempDir Path files) throws Exception {
    try (BareJade jade = new BareJade("agent-table", files)) {
      Object container = value(ContainerController.class, jade.main(), "myImpl");
      Object agents = value(container.getClass(), container, "localAgents");

      assertThat(value(agents.getClass(), agents, "agents")).isInstanceOf(AgentTable.class);
    }
  }

  private static Object value(Class<?> declaring, Object object, String name)
      throws ReflectiveOperationException {
    Field field = declaring.getDeclaredField(name);
    field.setAccessible(true);
    return field.get(object);
  }
}
