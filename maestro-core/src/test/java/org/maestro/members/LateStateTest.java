package org.maestro.members;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.knowledge.Household;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.MemberState;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Term;

/** A state that was sent before a result and comes after it is waited for, and not for long. */
class LateStateTest {
  private static final Duration MOMENT = Duration.ofMillis(100);
  private static final FeatureType READ =
      Household.feature("(sense (level ?self))", "(assign (level ?self) ?lux)");

  private final SteppedClock clock = new SteppedClock();
  private final MemberView view = new MemberView("listener", () -> {});
  private final List<RatsLink.CallListener> calls = new ArrayList<>();
  private final List<ActionDispatcher.Report> reports = new ArrayList<>();
  private final List<Duration> reportedAt = new ArrayList<>();
  private int over;
  private final MemberOrders orders =
      new MemberOrders("vat", link(), view, Runnable::run, clock, word -> {});

  @Test
  void whoTellsThatCallsAreOverIsHeardFirst() {
    view.said(state("former"));
    begin();
    answer(Outcome.SUCCEEDED);
    clock.run(Duration.ofMillis(10));
    assertThat(reports).isEmpty();
    assertThat(over).isZero();

    view.said(state("former", "call"));

    assertThat(includesStep()).contains(true);
    assertThat(over).isEqualTo(1);
    clock.run(Duration.ofSeconds(1));
    assertThat(reports).hasSize(1);
  }

  @Test
  void butNotForLong() {
    view.said(state("former"));
    begin();
    answer(Outcome.SUCCEEDED);
    clock.run(Duration.ofSeconds(1));

    assertThat(reportedAt).containsExactly(MOMENT);
    assertThat(includesStep()).contains(false);
    assertThat(over).isEqualTo(1);
  }

  @Test
  void whoHasToldSoAlreadyIsNotWaitedFor() {
    view.said(state());
    begin();
    view.said(state("call"));
    answer(Outcome.SUCCEEDED);

    assertThat(includesStep()).contains(true);
  }

  @Test
  void norIsWhoNeverTellsOrHasFailed() {
    begin();
    answer(Outcome.SUCCEEDED);
    assertThat(reports).as("it has said nothing at all").hasSize(1);

    view.said(state());
    begin();
    answer(Outcome.SUCCEEDED);
    assertThat(reports).as("it did not tell of the call before either").hasSize(2);

    view.said(state("former"));
    begin();
    answer(Outcome.FAILED);
    assertThat(reports).as("what failed teaches no effect").hasSize(3);
  }

  @Test
  void whoTellsOfWhatIsLearntIsHeardFirst() {
    view.said(telling("(= (level vat) 3)"));
    begin(READ);
    answer(Outcome.SUCCEEDED);
    assertThat(reports).isEmpty();

    clock.run(MOMENT);
    assertThat(reports).hasSize(1);
  }

  @Test
  void butWhoTellsOfSomethingElseIsNotWaitedFor() {
    view.said(telling("(= (warmth vat) 3)"));
    begin(READ);
    answer(Outcome.SUCCEEDED);

    assertThat(reports).hasSize(1);
  }

  private void begin() {
    begin(CountedOnceContract.FILL);
  }

  private void begin(FeatureType feature) {
    calls.clear();
    orders.begin(
        new MemberOrders.Order(
            feature,
            Map.of(),
            Duration.ofMinutes(1),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            Optional.empty(),
            false),
        new CallReporter.Listener() {
          @Override
          public void reported(Outcome outcome, ActionDispatcher.Report report) {
            reports.add(report);
            reportedAt.add(clock.now());
          }

          @Override
          public void learnt(Map<String, Term> outputs) {}

          @Override
          public void over() {
            over++;
          }
        });
  }

  private void answer(Outcome outcome) {
    calls.get(0).ended(new Result("call", "vat", outcome, "standby", Map.of(), Optional.empty()));
  }

  private Optional<Boolean> includesStep() {
    return reports.get(0).account().map(StepAccount::includesStep);
  }

  private static MemberState telling(String fact) {
    return new MemberState(
        "vat",
        "1",
        "standby",
        List.of(fact),
        List.of(),
        List.of(),
        List.of(),
        List.of(new MemberState.Ended("former", Outcome.SUCCEEDED)));
  }

  private static MemberState state(String... over) {
    return new MemberState(
        "vat",
        "1",
        "standby",
        List.of(),
        List.of(),
        List.of(),
        List.of(),
        Stream.of(over).map(call -> new MemberState.Ended(call, Outcome.SUCCEEDED)).toList());
  }

  /** One that only takes calls, all by the same name. */
  private RatsLink link() {
    RatsLink.CallHandle handle =
        new RatsLink.CallHandle() {
          @Override
          public String callId() {
            return "call";
          }

          @Override
          public void cancel() {}
        };
    return (RatsLink)
        Proxy.newProxyInstance(
            RatsLink.class.getClassLoader(),
            new Class<?>[] {RatsLink.class},
            (proxy, method, arguments) -> {
              calls.add((RatsLink.CallListener) arguments[1]);
              return handle;
            });
  }
}
