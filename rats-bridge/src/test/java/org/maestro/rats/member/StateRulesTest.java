package org.maestro.rats.member;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;

/** How the state of a member changes: by execution, by the world, by time, and by force. */
class StateRulesTest extends MemberOnABus {

  private final AtomicInteger powerCuts = new AtomicInteger();

  @Override
  MemberProfile profile() {
    MemberProfile usual = device.profile();
    return new MemberProfile(
        "rose",
        usual.description(),
        Set.of("standby", "busy", "holding", "dozing", "powerless"),
        "standby",
        Set.of("standby", "powerless"),
        usual.features(),
        new StateRules(
            Map.of("holding", Set.of("standby", "dozing"), "dozing", Set.of("standby")),
            Map.of("dozing", new StateRules.AfterTime(Duration.ofSeconds(5), "standby")),
            Optional.of(new StateRules.LastResort("powerless", powerCuts::incrementAndGet)),
            Duration.ofSeconds(30)));
  }

  /** Three-layered architecture, 3.2.1 (M35): while executing. */
  @Test
  void showsItsWholeTuple() {
    RatsMember.Tuple before = member.tuple();
    send(call("c1", "drive", Map.of("to", "zone-a")));
    run(1);
    RatsMember.Tuple meanwhile = member.tuple();

    assertThat(before.id()).isEqualTo("rose");
    assertThat(before.features())
        .isEqualTo(profile().features().keySet())
        .contains("drive", "watch", "unwatch");
    assertThat(before.states()).isEqualTo(profile().states());
    assertThat(before.safeStates()).isEqualTo(profile().safeStates()).isNotEmpty();
    assertThat(before.state()).isEqualTo(profile().initialState());
    assertThat(meanwhile.state()).isEqualTo("busy").isIn(meanwhile.states());
  }

  @Test
  void changesByExecution() {
    send(call("c1", "drive", Map.of("to", "a")));
    run(1);
    assertThat(state.orElseThrow().state()).isEqualTo("busy");
    run(2);
    assertThat(state.orElseThrow().state()).isEqualTo("standby");
  }

  /**
   * Three-layered architecture, 3.2.1 (M35): by a change of the world, which also disables what is
   * not possible from there (Three-layered architecture, 3.2.1; M33).
   */
  @Test
  void changesByTheWorldAndDisablesWhatCannotFollow() {
    member.rest("holding");
    run(1);
    assertThat(state.orElseThrow().state()).isEqualTo("holding");
    assertThat(state.orElseThrow().disabled()).containsExactly("drive", "grip", "wave");
    send(call("c1", "drive", Map.of("to", "a")));
    run(1);
    assertRejected(only(), ErrorCode.DISABLED);
    assertThat(only().error().orElseThrow().message()).contains("holding");
    member.rest("standby");
    run(1);
    assertThat(state.orElseThrow().disabled()).isEmpty();
  }

  /** Three-layered architecture, 3.2.1 (M35): by time. */
  @Test
  void changesByTime() {
    member.rest("dozing");
    run(4);
    assertThat(state.orElseThrow().state()).isEqualTo("dozing");
    run(2);
    assertThat(state.orElseThrow().state()).isEqualTo("standby");
  }

  @Test
  void refusesTransitionsThatAreNotLegal() {
    member.rest("dozing");
    assertThatThrownBy(() -> member.rest("holding"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("dozing")
        .hasMessageContaining("holding");
  }

  /**
   * Three-layered architecture, 3.2.1 (M45): an exit that does not end is forced, and people are
   * alerted.
   */
  @Test
  void forcesTheStrongestSafeStateWhenAnExitDoesNotEnd() {
    device.gripNeverLetsGo = true;
    send(call("c1", "grip", Map.of()));
    run(1);
    send(call("x1", "$cancel", Map.of("id", "c1")));
    run(70);
    assertForced();
  }

  @Test
  void forcesTheStrongestSafeStateWhenAnExitBreaksOff() {
    device.gripBreaksOnExit = true;
    send(call("c1", "grip", Map.of()));
    run(1);
    send(call("x1", "$cancel", Map.of("id", "c1")));
    run(1);
    assertForced();
  }

  private void assertForced() {
    assertThat(powerCuts).hasValue(1);
    assertThat(state.orElseThrow().state()).isEqualTo("powerless");
    assertThat(observations)
        .singleElement()
        .asString()
        .contains("c1", "powerless", "exit strategy");
    assertThat(results)
        .filteredOn(result -> result.id().equals("c1"))
        .singleElement()
        .satisfies(
            result -> {
              assertThat(result.outcome()).isEqualTo(Outcome.CANCELED);
              assertThat(result.error().orElseThrow().level()).isEqualTo(RatsError.Level.ERROR);
              assertThat(result.state()).isEqualTo("powerless");
            });
  }

  @Test
  void nothingStartsWhileItBecomesSafe() {
    send(call("c1", "grip", Map.of()));
    run(1);
    send(with(call("s1", "$safe", Map.of()), Optional.empty()));
    send(call("c2", "wave", Map.of()));
    run(1);
    assertRejected(only(), ErrorCode.DISABLED);
    run(5);
    assertThat(device.log).noneMatch(line -> line.contains("wave"));
    send(call("c3", "echo", Map.of()));
    run(1);
    assertThat(results.get(results.size() - 1).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  /** Three-layered architecture, 3.2.1 (M37): however much is asked of it at the same time. */
  @Test
  void isSafeWithinATenthOfASecondWhateverWaits() {
    for (int number = 0; number < 200; number++) {
      send(call("c" + number, "drive", Map.of("to", "a")));
    }
    Duration before = clock.now();
    send(with(call("s1", "$safe", Map.of()), Optional.empty()));
    run(1);
    int safe = results.indexOf(results.stream().filter(r -> r.id().equals("s1")).findFirst().get());
    assertThat(resultTimes.get(safe).minus(before)).isLessThan(Duration.ofMillis(100));
    assertThat(state.orElseThrow().running()).isEmpty();
    assertThat(state.orElseThrow().queue()).isEmpty();
    assertThat(results).hasSize(201);
  }

  /**
   * Three-layered architecture, 2 (M9): a second member of the same id leaves, whichever client id
   * it has.
   */
  @Test
  void theSecondOfTheSameIdHasToLeave() {
    for (String client : List.of("rose", "another")) {
      RatsMember twin = RatsMember.start(profile(), List::of, bus.client(client), "test", clock);
      run(10);
      assertThat(twin.isRefused()).as(client).isTrue();
      assertThat(member.isRefused()).isFalse();
      send(call("after-" + client, "echo", Map.of()));
      run(1);
      assertThat(results.get(results.size() - 1).id()).isEqualTo("after-" + client);
      assertThat(retained.get(retained.size() - 1)).isEqualTo("READY");
    }
  }

  /** Three-layered architecture, 2 (M11). */
  @Test
  void refusesTwoFeaturesOfTheSameId() {
    MemberProfile.Feature drive = device.profile().features().get("drive");
    assertThatThrownBy(() -> MemberProfile.byId(List.of(drive, drive)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("drive");
    MemberProfile usual = device.profile();
    assertThatThrownBy(
            () ->
                new MemberProfile(
                    "x", "", usual.states(), "standby", Set.of("standby"), Map.of("fly", drive)))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void refusesALastResortThatIsNotSafe() {
    MemberProfile usual = device.profile();
    StateRules rules =
        new StateRules(
            Map.of(),
            Map.of(),
            Optional.of(new StateRules.LastResort("busy", () -> {})),
            Duration.ofSeconds(1));
    assertThatThrownBy(
            () ->
                new MemberProfile(
                    "x", "", usual.states(), "standby", Set.of("standby"), usual.features(), rules))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("busy");
  }
}
