package org.maestro.rats.link;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.rats.member.RatsMember;
import org.maestro.rats.member.TestDevice;
import org.maestro.rats.protocol.CostAnswer;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.SteppedClock;
import org.maestro.rats.transport.InProcessBus;

/** A member asks others over the connection on which it is asked itself. */
class MemberCallsTest {

  private static final String SITE = "test";
  private static final Duration LIMIT = Duration.ofSeconds(30);

  private final SteppedClock clock = new SteppedClock();
  private final InProcessBus bus = new InProcessBus(clock);
  private final MemberCalls lamps = new MemberCalls("lamp", SITE, bus.client("lamp"), clock);
  private final TestDevice lamp = new TestDevice("lamp", clock);
  private final TestDevice door = new TestDevice("door", clock);
  private final List<Result> results = new ArrayList<>();

  private RatsMember join() {
    RatsMember.start(lamp.profile(), List::of, lamps.transport(), SITE, clock);
    RatsMember other = RatsMember.start(door.profile(), List::of, bus.client("door"), SITE, clock);
    run(1);
    return other;
  }

  private RatsLink.CallHandle calls(String member, String feature) {
    return lamps.call(member, feature, Map.of("to", "b"), LIMIT, results::add);
  }

  @Test
  void asksForPricesAndCallsAndIsCalledMeanwhile() {
    join();
    List<CostAnswer> prices = new ArrayList<>();
    lamps.cost("door", "drive", List.of(Map.of("to", "b")), prices::addAll);
    calls("door", "drive");
    try (RatsLink link = BusLink.connect("cca", SITE, bus.client("cca"), clock)) {
      run(1);
      link.call("lamp", "echo", Map.of("a", 1), LIMIT, Optional.empty(), results::add);
      run(10);
    }

    assertThat(prices).singleElement().matches(price -> price.cost().equals(Optional.of(2.5)));
    assertThat(results)
        .extracting(Result::from, Result::outcome)
        .containsExactly(tuple("lamp", Outcome.SUCCEEDED), tuple("door", Outcome.SUCCEEDED));
    assertThat(door.log).hasSize(2);
  }

  @Test
  void endsWhatItBegan() {
    join();
    RatsLink.CallHandle drive = calls("door", "drive");
    drive.cancel();
    run(5);
    assertThat(results).singleElement().matches(r -> r.outcome() == Outcome.CANCELED);
  }

  @Test
  void isToldThatNobodyIsThereOrAnyMore() {
    RatsMember other = join();
    calls("nobody", "drive");
    calls("door", "drive");
    run(1);
    other.die();
    run(5);
    calls("door", "drive");
    run(6);

    assertThat(results)
        .hasSize(3)
        .allMatch(result -> result.error().orElseThrow().code() == ErrorCode.MEMBER_LOST);
    assertThatThrownBy(() -> calls("lamp", "echo")).hasMessageContaining("calls itself");
  }

  @Test
  void waitsForAStatusThatComesLateAsLongAsTheCallMayTake() {
    join();
    TestDevice late = new TestDevice("late", clock);
    lamps.call("late", "drive", Map.of("to", "b"), LIMIT, results::add);
    lamps.call("late", "drive", Map.of("to", "b"), Duration.ofSeconds(2), results::add);
    run(3);
    assertThat(results)
        .singleElement()
        .matches(result -> result.error().orElseThrow().code() == ErrorCode.MEMBER_LOST);

    RatsMember.start(late.profile(), List::of, bus.client("late"), SITE, clock);
    run(10);
    assertThat(results)
        .as("%s", results)
        .extracting(Result::outcome)
        .containsExactly(Outcome.FAILED, Outcome.SUCCEEDED);
    assertThat(late.log).hasSize(2);
  }

  private void run(int seconds) {
    clock.run(Duration.ofSeconds(seconds));
  }
}
