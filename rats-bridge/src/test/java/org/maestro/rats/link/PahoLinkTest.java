package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInfo;
import org.maestro.rats.broker.TestBroker;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

class PahoLinkTest extends PahoLinkContract {

  private static final TestBroker BROKER = TestBroker.embedded();

  @BeforeAll
  static void startBroker() {
    BROKER.start();
  }

  @AfterAll
  static void stopsWithoutTrace(TestInfo test) {
    BROKER.stop();
    assertNoThreadIsLeft(test);
  }

  /** It would not tell the members of the flag. */
  @Test
  void refusesACallThatIsRetained() {
    List<String> refused = new CopyOnWriteArrayList<>();
    List<String> taken = new CopyOnWriteArrayList<>();
    AtomicBoolean connected = new AtomicBoolean();
    Transport careless = client("careless");
    careless.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            connected.set(true);
          }

          @Override
          public void lost(String reason) {
            refused.add("the connection, " + reason);
          }
        });
    try {
      await(connected::get);
      for (String topic : List.of("call", "call/careless", "member/call/status")) {
        careless.publish(
            Publication.retained("rats/1/a.b/" + topic, new byte[] {'x'}),
            failure -> (failure.isPresent() ? refused : taken).add(topic));
      }
      await(() -> refused.size() + taken.size() == 3);
      assertThat(refused).containsExactly("call", "call/careless");
      assertThat(taken).containsExactly("member/call/status");
      careless.publish(
          Publication.clearing("rats/1/a.b/member/call/status"), failure -> taken.add("cleared"));
      await(() -> taken.size() == 2);
    } finally {
      careless.close();
    }
  }

  @Override
  TestBroker broker() {
    return BROKER;
  }
}
