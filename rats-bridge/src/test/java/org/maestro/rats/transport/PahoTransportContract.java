package org.maestro.rats.transport;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.maestro.rats.broker.TestBroker;

/** What {@link PahoTransport} must do over each broker. */
abstract class PahoTransportContract extends TransportContract {

  private TestBroker broker;

  abstract TestBroker broker();

  @BeforeEach
  void startBroker() {
    broker = broker();
    broker.start();
  }

  @AfterEach
  void closeBroker() {
    broker.stop();
  }

  /** Other classes run beside this one: only its own clients count. */
  @AfterAll
  static void leavesNoThread(TestInfo test) {
    String own = prefix(test.getTestClass().orElseThrow());
    Awaitility.await()
        .atMost(Duration.ofSeconds(5))
        .untilAsserted(
            () ->
                assertThat(Thread.getAllStackTraces().keySet())
                    .extracting(Thread::getName)
                    .noneMatch(name -> name.contains(own)));
  }

  private static String prefix(Class<?> test) {
    return test.getSimpleName() + "-";
  }

  @Override
  Transport client(String id) {
    return new PahoTransport(broker.uri(), prefix(getClass()) + id);
  }

  @Override
  void stopBroker() {
    broker.stop();
  }

  @Override
  void restartBroker() {
    broker.start();
  }

  @Override
  void await(BooleanSupplier condition) {
    Awaitility.await()
        .pollDelay(Duration.ZERO)
        .pollInterval(Duration.ofMillis(2))
        .atMost(Duration.ofSeconds(10))
        .until(condition::getAsBoolean);
  }

  @Test
  void keepsTryingWhileThereIsNoBroker() {
    broker.stop();
    StringBuffer reasons = new StringBuffer();
    Transport client = client("early");
    client.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            reasons.append("connected");
          }

          @Override
          public void lost(String reason) {
            reasons.append("lost ");
          }
        });
    await(() -> reasons.toString().startsWith("lost lost"));
    restartBroker();
    await(() -> reasons.toString().endsWith("connected"));
    client.close();
  }
}
