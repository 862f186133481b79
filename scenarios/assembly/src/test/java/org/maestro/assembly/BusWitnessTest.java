package org.maestro.assembly;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** Who watches for what is done twice sees it, and does not look for what is not there. */
class BusWitnessTest {
  private static final String CUP = "https://example.org/home#Cup";

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final Topics topics = new Topics("watched");
  private final WireFormat wire = new WireFormat();
  private final BusWitness witness = BusWitness.listen(bus.client("witness"), "watched");
  private final Transport client = bus.client("client");

  @BeforeEach
  void open() {
    client.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // Nothing waits for it.
          }

          @Override
          public void lost(String reason) {
            // It is not.
          }
        });
    clock.run(Duration.ofSeconds(1));
  }

  @AfterEach
  void close() {
    client.close();
    witness.close();
  }

  @Test
  void aRepeatAtASlightlyOtherPoseIsOne() {
    done("c1", "G1", Map.of("object", Map.of("ref", CUP, "position", List.of(5.19, 2.21, 0))));
    assertThat(witness.doneTwice(Set.of("pick"))).isEmpty();

    done("c2", "G1", Map.of("object", Map.of("ref", CUP, "position", List.of(5.2, 2.2, 0))));
    assertThat(witness.doneTwice(Set.of("pick"))).singleElement().asString().contains("pick");
  }

  @Test
  void whatIsDoneForAnotherGoalOrToAnotherThingIsNone() {
    done("c1", "G1", Map.of("object", Map.of("ref", CUP)));
    done("c2", "G2", Map.of("object", Map.of("ref", CUP)));
    done("c3", "G1", Map.of("object", Map.of("ref", CUP + "2")));
    done("c4", "G1", Map.of("object", Map.of("ref", CUP), "level", 0.5));

    assertThat(witness.doneTwice(Set.of("pick"))).isEmpty();
  }

  @Test
  void toLookForAFeatureThatIsNotThereIsAnError() {
    done("c1", "G1", Map.of());

    assertThatThrownBy(() -> witness.doneTwice(Set.of("pick", "pickUp")))
        .isInstanceOf(IllegalStateException.class)
        .hasMessageContaining("pickUp");
  }

  private void done(String id, String goal, Map<String, Object> parameters) {
    Call call =
        new Call(
            id,
            Optional.of("rose"),
            Optional.empty(),
            "pick",
            parameters,
            Duration.ofSeconds(10),
            "client",
            Optional.of(goal));
    Result result = new Result(id, "rose", Outcome.SUCCEEDED, "idle", Map.of(), Optional.empty());
    publish(topics.call("client"), wire.encode(call));
    publish(topics.result("client", "rose"), wire.encode(result));
  }

  private void publish(String topic, byte[] payload) {
    client.publish(Publication.reliable(topic, payload, Optional.empty()), failure -> {});
    clock.run(Duration.ofSeconds(1));
  }
}
