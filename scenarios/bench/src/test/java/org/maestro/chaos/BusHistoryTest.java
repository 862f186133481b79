package org.maestro.chaos;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** What may not be is seen. */
class BusHistoryTest {
  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final WireFormat wire = new WireFormat();
  private final BusHistory history = new BusHistory();
  private final Transport everybody = bus.client("everybody");

  @BeforeEach
  void listen() {
    history.listen(bus, clock);
    everybody.open(Optional.empty(), new Stranger.Unconcerned());
    clock.run(Duration.ofSeconds(1));
  }

  @Test
  void nothingIsFoundInAProperCall() {
    call("c1", "rose");
    call("c1", "rose");
    runs("rose", "c1");
    runs("rose", "c1");
    runs("rose");
    assertThat(history.findings()).isEmpty();
  }

  @Test
  void aCallThatRunsTwiceIsFound() {
    call("c1", "rose");
    runs("rose", "c1");
    runs("rose");
    runs("rose", "c1");
    assertFinding("TWICE");
  }

  @Test
  void soIsOneThatNobodyMade() {
    runs("rose", "c1");
    assertFinding("NO_CONTRACT");
  }

  @Test
  void andOneThatWasMeantForAnother() {
    call("c1", "tim");
    runs("rose", "c1");
    assertFinding("WRONG_DOER");
  }

  @Test
  void andOneAfterItsTime() {
    call("c1", "rose");
    clock.run(Duration.ofSeconds(60));
    runs("rose", "c1");
    assertFinding("TOO_LATE");
  }

  private void assertFinding(String kind) {
    assertThat(history.findings()).singleElement().asString().startsWith(kind + " rose");
  }

  private void call(String id, String member) {
    Call call =
        new Call(
            id,
            Optional.of(member),
            Optional.empty(),
            "drive",
            Map.of(),
            Duration.ofSeconds(5),
            "maestro",
            Optional.empty());
    say(Publication.reliable("rats/1/home/call/maestro", wire.encode(call), Optional.empty()));
  }

  private void runs(String member, String... calls) {
    MemberState state =
        new MemberState(member, "b", "busy", List.of(), List.of(calls), List.of(), List.of());
    say(Publication.retained("rats/1/home/member/" + member + "/state", wire.encode(state)));
  }

  private void say(Publication publication) {
    everybody.publish(publication, failure -> assertThat(failure).isEmpty());
    clock.run(Duration.ofMillis(100));
  }
}
