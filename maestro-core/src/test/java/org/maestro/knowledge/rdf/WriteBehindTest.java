package org.maestro.knowledge.rdf;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import org.apache.jena.graph.NodeFactory;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;

class WriteBehindTest {

  /** However much is said meanwhile: each new edit woke it, and it tried at once. */
  @Test
  void aStoreThatFailsIsNotTriedWithEachEdit() {
    Failing store = new Failing();
    try (WriteBehind behind = new WriteBehind(store, Duration.ofSeconds(1)).begin()) {
      edit(behind);
      Awaitility.await().until(() -> store.tries.get() == 1);
      long begun = System.nanoTime();
      for (int i = 0; i < 1_000; i++) {
        edit(behind);
        Thread.onSpinWait();
      }
      long passed = Duration.ofNanos(System.nanoTime() - begun).toMillis();

      assertThat(store.tries.get()).isLessThanOrEqualTo((int) (passed / 500) + 2);
      store.works = true;
      Awaitility.await().until(() -> store.taken.get() == 1_001);
    }
  }

  private static void edit(WriteBehind behind) {
    behind.replace(NodeFactory.createURI("urn:graph"), List.of());
  }

  private static final class Failing implements GraphStorage {
    private final AtomicInteger tries = new AtomicInteger();
    private final AtomicInteger taken = new AtomicInteger();
    private volatile boolean works;

    @Override
    public void apply(List<Edit> edits) {
      tries.incrementAndGet();
      if (!works) {
        throw new IllegalStateException("The store takes nothing.");
      }
      taken.addAndGet(edits.size());
    }

    @Override
    public List<Map<String, String>> select(String query, Duration within) {
      return List.of();
    }

    @Override
    public boolean isLasting() {
      return true;
    }

    @Override
    public void close() {}
  }
}
