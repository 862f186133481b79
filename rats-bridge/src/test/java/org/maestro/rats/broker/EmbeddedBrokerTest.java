package org.maestro.rats.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;

@Isolated("other tests start threads and write to the log")
class EmbeddedBrokerTest {

  @Test
  void refusesABusyPortInOneSentence() {
    try (EmbeddedBroker broker = EmbeddedBroker.start()) {
      int port = broker.uri().getPort();
      assertThatThrownBy(() -> EmbeddedBroker.start(port))
          .isInstanceOf(BrokerStartException.class)
          .hasMessageContaining("127.0.0.1:" + port);
    }
  }

  @Test
  void leavesNoThreadBehind() {
    Set<Thread> before = Thread.getAllStackTraces().keySet();
    for (int round = 0; round < 3; round++) {
      EmbeddedBroker.start().close();
    }
    await()
        .atMost(Duration.ofSeconds(10))
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces().keySet())
                    .filteredOn(thread -> !before.contains(thread))
                    .extracting(Thread::getName)
                    .filteredOn(name -> !name.startsWith("awaitility"))
                    .isEmpty());
  }
}
