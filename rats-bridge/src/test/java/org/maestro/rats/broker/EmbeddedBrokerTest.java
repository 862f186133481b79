package org.maestro.rats.broker;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.rats.transport.PahoTransport;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

@Isolated("other tests start threads and write to the log")
class EmbeddedBrokerTest {
  private static final Duration SHORT = Duration.ofSeconds(1);

  @Test
  void refusesABusyPortInOneSentence() {
    try (EmbeddedBroker broker = EmbeddedBroker.start()) {
      int port = broker.uri().getPort();
      assertThatThrownBy(() -> EmbeddedBroker.start(port))
          .isInstanceOf(BrokerStartException.class)
          .hasMessageContaining("127.0.0.1:" + port);
    }
  }

  /** Artemis keeps for a client what it said itself and does not want to hear. */
  @Test
  void keepsNothingForLongOfWhatNobodyWantsToHear() {
    try (EmbeddedBroker broker = EmbeddedBroker.start();
        Transport client = new PahoTransport(broker.uri(), "maestro")) {
      client.subscribeToOthers("calls/#", call -> {});
      client.open(Optional.empty(), new Quiet());
      await()
          .until(
              () -> {
                client.publish(
                    Publication.reliable("calls/maestro", new byte[100], Optional.of(SHORT)),
                    failure -> {});
                return broker.waiting() >= 20;
              });
      await().atMost(Duration.ofSeconds(15)).until(() -> broker.waiting() < 20);
    }
  }

  private static final class Quiet implements Transport.ConnectionListener {
    @Override
    public void connected() {
      // It is seen by what is sent.
    }

    @Override
    public void lost(String reason) {
      // So it is.
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
