package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.transport.Transport;

/** What becomes of calls that a controller made in a life before this one. */
abstract class FormerLivesContract extends ForeignDevicesContract {

  @Test
  void takesUpTheCallsOfItsFormerLife() {
    TestDevice device = new TestDevice("anna", clock());
    String boot = join(device, "home").boot();
    Transport formerTransport = client("cca");
    RatsLink former = BusLink.connect("cca", "home", formerTransport, clock());
    await(() -> usable(former, "anna"));
    RatsLink.Order drive = order("G1-1", boot, "drive", Map.of("to", "a"));
    RatsLink.Order queued = order("G1-2", boot, "drive", Map.of("to", "b"));
    RatsLink.Order watch = order("G1-3", boot, "watch", Map.of("object", "Cup"));
    RatsLink.Order echo = order("G1-4", boot, "echo", Map.of("a", 1.5, "b", List.of(1.0, 2.0)));
    Map<RatsLink.Order, Listener> before = new LinkedHashMap<>();
    for (RatsLink.Order order : List.of(drive, queued, watch, echo)) {
      before.put(order, new Listener());
      former.call(order, before.get(order));
    }
    await(
        () ->
            before.get(echo).ended()
                && before.get(drive).progress.size() == 2
                && before.get(watch).observations.size() > 0);
    formerTransport.die();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Map<RatsLink.Order, Listener> after = new LinkedHashMap<>();
    for (RatsLink.Order order : List.of(drive, queued, watch, echo)) {
      after.put(order, new Listener());
      link.call(order, after.get(order));
    }
    await(
        () ->
            after.get(drive).ended()
                && after.get(queued).ended()
                && after.get(echo).ended()
                && after.get(watch).observations.size() > 1);
    assertThat(after.get(drive).only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(after.get(queued).only().outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(after.get(echo).only()).isEqualTo(before.get(echo).only());
    assertThat(after.get(watch).progress)
        .extracting(Progress::kind)
        .containsExactly(Progress.Kind.ESTABLISHED);
    assertThat(device.log)
        .extracting(line -> line.substring(line.indexOf(' ') + 1))
        .containsOnlyOnce("start watch", "start echo")
        .filteredOn("start drive"::equals)
        .hasSize(2);
  }

  @Test
  void refusesForeignWordsAndLivesForACallOfAFormerLife() {
    TestDevice device = new TestDevice("anna", clock());
    String boot = join(device, "home").boot();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener first = new Listener();
    link.call(order("G1-1", boot, "echo", Map.of("a", 1)), first);
    await(first::ended);
    Listener other = new Listener();
    link.call(order("G1-1", boot, "echo", Map.of("a", 2)), other);
    Listener late = new Listener();
    link.call(order("G1-2", "a-former-one", "echo", Map.of()), late);
    await(() -> other.ended() && late.ended());
    assertThat(other.only().error().orElseThrow().code()).isEqualTo(ErrorCode.DUPLICATE_ID);
    assertFailed(late.only(), ErrorCode.RESTARTED);
    assertThat(device.log).hasSize(1);
  }

  @Test
  void hearsWhatBecomesOfACallThatItEndsAndMakesNoneForThat() {
    TestDevice device = new TestDevice("anna", clock());
    String boot = join(device, "home").boot();
    Transport formerTransport = client("cca");
    RatsLink former = BusLink.connect("cca", "home", formerTransport, clock());
    await(() -> usable(former, "anna"));
    RatsLink.Order grip = order("G1-1", boot, "grip", Map.of());
    Listener gripping = new Listener();
    former.call(grip, gripping);
    await(() -> gripping.progress.size() > 1);
    formerTransport.die();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna"));
    Listener ended = new Listener();
    link.end(grip, ended);
    Listener neverBegun = new Listener();
    link.end(order("G1-2", boot, "drive", Map.of("to", "a")), neverBegun);
    await(() -> ended.ended() && neverBegun.ended());
    assertThat(ended.only().outcome()).isIn(Outcome.CANCELED, Outcome.FAILED);
    assertFailed(neverBegun.only(), ErrorCode.CANCELED);
    await(() -> running(link, "anna").isEmpty());
    assertThat(device.log).noneMatch(line -> line.endsWith("start drive"));
  }

  @Test
  void endsACallOfItsFormerLife() {
    RatsMember anna = join("anna", "home");
    Transport formerTransport = client("cca");
    RatsLink former = BusLink.connect("cca", "home", formerTransport, clock());
    await(() -> usable(former, "anna"));
    Listener watching = new Listener();
    former.call(order("G1-1", anna.boot(), "watch", Map.of("object", "Cup")), watching);
    await(() -> watching.observations.size() > 0);
    formerTransport.die();
    RatsLink link = connect("cca", "home");
    await(() -> usable(link, "anna") && running(link, "anna").contains("G1-1"));
    link.cancel("anna", anna.boot(), "G1-1");
    await(() -> running(link, "anna").isEmpty());
  }
}
