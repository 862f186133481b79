package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.Verdict;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Transport;

/** What a controller makes of a description is retained for the member that has it. */
class VerdictsTest {
  private static final Verdict WRONG =
      new Verdict(
          "bell",
          "b1",
          false,
          List.of(new Verdict.Fault(0, "ring", "effect", "is odd", "mend it")));
  private static final Verdict RIGHT = new Verdict("bell", "b1", true, List.of());

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final WireFormat wire = new WireFormat();
  private final List<Optional<Verdict>> heard = new ArrayList<>();
  private final RatsLink link = BusLink.connect("cca", "home", bus.client("cca"), clock);

  @BeforeEach
  void listen() {
    Transport bell = bus.client("bell");
    bell.subscribe(
        new Topics("home").verdicts("bell"),
        Transport.RetainedMessages.SEND,
        message ->
            heard.add(
                message.payload().length == 0
                    ? Optional.empty()
                    : Optional.of(wire.decodeVerdict(message.payload()))));
    bell.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {}

          @Override
          public void lost(String reason) {}
        });
    pass();
  }

  private void pass() {
    clock.run(Duration.ofSeconds(1));
  }

  @Test
  void aRefusalAndItsEndAreToldOnceEach() {
    link.tell(RIGHT);
    pass();
    assertThat(heard).as("all was right from the beginning").isEmpty();
    link.tell(WRONG);
    link.tell(WRONG);
    link.tell(RIGHT);
    pass();
    assertThat(heard).containsExactly(Optional.of(WRONG), Optional.of(RIGHT));
  }

  @Test
  void itIsToldAgainWhenTheBusComesBackEmpty() {
    link.tell(WRONG);
    pass();
    bus.stop();
    bus.restart();
    pass();
    assertThat(heard).containsExactly(Optional.of(WRONG), Optional.of(WRONG));
  }

  @Test
  void itIsTakenBackWhenTheControllerLeaves() {
    link.tell(WRONG);
    pass();
    link.close();
    pass();
    assertThat(heard).containsExactly(Optional.of(WRONG), Optional.empty());
  }

  @Test
  void ofVeryManyFaultsTheFirstAreTold() {
    Verdict.Fault longOne = new Verdict.Fault(1, "x".repeat(9000), "", "is odd", "mend it");
    link.tell(new Verdict("bell", "b1", false, Collections.nCopies(5_000, longOne)));
    pass();
    assertThat(heard).hasSize(1);
    assertThat(heard.get(0).orElseThrow().faults()).hasSize(Verdict.MOST_FAULTS);
  }

  @Test
  void whatIsOddInAFaultIsToldAllTheSame() {
    String astral = "x" + "\ud835\udc00".repeat(600) + "\ud835";
    Verdict.Fault odd = new Verdict.Fault(0, astral, astral, astral, "\u0001".repeat(9000));
    link.tell(new Verdict("bell", "b1", false, Collections.nCopies(50, odd)));
    pass();
    bus.stop();
    bus.restart();
    pass();
    assertThat(heard).hasSize(2);
    assertThat(heard.get(0).orElseThrow().faults()).isNotEmpty();
  }
}
