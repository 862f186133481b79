package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.ReservedFeature;
import org.maestro.rats.protocol.Topics;
import org.maestro.rats.protocol.WireFormat;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.rats.transport.Transport;

/** An alarm that comes after its call's end, or of no call at all, is heard all the same. */
class LateAlertTest {

  private static final String SITE = "test";

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final RatsLink link = BusLink.connect("cca", SITE, bus.client("cca"), clock);
  private final Transport rose = bus.client("rose");

  @Test
  void isToldToWhoWatchesTheMember() {
    List<String> alarms = new ArrayList<>();
    link.watch(
        new RatsLink.MemberListener() {
          @Override
          public void changed(RatsLink.Member member) {
            // Only alarms matter here.
          }

          @Override
          public void alerted(String member, String callId, String message) {
            alarms.add(member + " " + callId + ": " + message);
          }
        });
    rose.open(
        Optional.empty(),
        new Transport.ConnectionListener() {
          @Override
          public void connected() {
            // It speaks only.
          }

          @Override
          public void lost(String reason) {
            // It speaks only.
          }
        });
    clock.run(Duration.ofSeconds(1));
    tell(new Observation("cca-1-1", "rose", ReservedFeature.ALERT, Map.of("message", "it burns")));
    tell(new Observation("cca-1-1", "rose", "watch", Map.of("message", "no alarm")));
    clock.run(Duration.ofSeconds(1));

    assertThat(alarms).containsExactly("rose cca-1-1: it burns");
  }

  private void tell(Observation observation) {
    rose.publish(
        Publication.stream(
            new Topics(SITE).observation("rose", observation.feature()),
            new WireFormat().encode(observation)),
        failure -> assertThat(failure).isEmpty());
  }
}
