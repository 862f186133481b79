package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.time.ZoneId;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.InvalidGoalException;
import org.maestro.coordination.contention.ResourceClaimsTest;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Script;
import org.maestro.sl.SlParser;

/** Goals that begin or end at a time or an event; the clock begins at one o'clock in Berlin. */
class AgendaTest {
  private static Home home;

  private NarrowHouse house;

  @BeforeAll
  static void loadHome() throws IOException {
    Home narrow = ResourceClaimsTest.narrowHome();
    home =
        narrow
            .in(ZoneId.of("Europe/Berlin"))
            .withScripts(
                Map.of(
                    "fetch",
                    script("fetch", List.of("?item - Item"), "(achieve (in ?item zone-a))"),
                    "flip",
                    script(
                        "flip",
                        List.of(),
                        "(seq (assert (not (in Mug zone-c))) (assert (in Mug zone-c)))")));
  }

  private static Script script(String name, List<String> parameters, String body) {
    return new Script(
        name,
        name,
        parameters.stream().map(SlParser::variable).toList(),
        SlParser.body(body, fluent -> false),
        Optional.empty(),
        Optional.empty(),
        Optional.empty());
  }

  private NarrowHouse house() {
    house = new NarrowHouse(home, 1).with("rose", "zone-a").with("Cup", "zone-b");
    return house;
  }

  private void told(String fact) {
    house.knowledge.state(new Source(Source.Kind.STATED, "us"), List.of(fact));
    house.clock.run(Duration.ofMillis(10));
  }

  private List<String> ids() {
    return house.coordinator.goals().stream().map(GoalStatus::id).toList();
  }

  @Test
  void atItsTimeAGoalIsBegunAndBothNameEachOther() {
    house();
    String id = house.wish("(at \"01:05\" (in Cup zone-a))");
    house.clock.run(Duration.ofSeconds(299));
    assertThat(house.state(id)).isEqualTo(GoalState.WAITING);
    assertThat(house.status(id).detail()).isEqualTo("for 2026-01-01 01:05");
    assertThat(house.status(id).goal()).isEqualTo("(at \"01:05\" (in Cup zone-a))");
    assertThat(house.calls).isEmpty();

    house.clock.run(Duration.ofSeconds(2));
    assertThat(house.state(id)).isEqualTo(GoalState.RUNNING);
    assertThat(house.status(id).detail()).isEqualTo("G2");
    assertThat(house.run(1, Duration.ofMinutes(5))).as(house.told()).isTrue();

    assertThat(house.outcomes.get(id).reached()).isTrue();
    assertThat(house.outcomes.get(id).calls()).isEqualTo(4);
    assertThat(house.place).containsEntry("Cup", "zone-a");
    assertThat(house.told())
        .contains(
            "G1 STEP Begins G2, because it was to be begun at 2026-01-01 01:05: (in Cup zone-a).",
            "G2 GOAL Begun by G1, because it was to be begun at 2026-01-01 01:05.");
    assertThat(ids()).containsExactly("G1", "G2");
  }

  @Test
  void eachDayAnotherGoalIsBegunUntilItIsCancelled() {
    house();
    String id = house.wish("(at \"01:30\" :every \"day\" (fetch Cup))");
    house.clock.run(Duration.ofDays(2));

    assertThat(ids()).as(house.told()).containsExactly("G1", "G2", "G3");
    assertThat(house.status(id).detail()).isEqualTo("for 2026-01-03 01:30");
    assertThat(house.coordinator.cancel(id, "Bob")).isTrue();
    house.clock.run(Duration.ofDays(2));

    assertThat(house.outcomes.get(id).state()).isEqualTo(GoalState.CANCELLED);
    assertThat(ids()).containsExactly("G1", "G2", "G3");
    assertThat(house.state("G3").isFinal()).isTrue();
  }

  @Test
  void afterSomeSecondsItIsBegunAndCancelledWithWhoWaitsForIt() {
    house();
    String id = house.wish("(after 90 (in Cup zone-a))");
    house.clock.run(Duration.ofSeconds(89));
    assertThat(house.calls).isEmpty();
    house.clock.run(Duration.ofSeconds(3));
    assertThat(house.state("G2")).isEqualTo(GoalState.RUNNING);

    house.coordinator.cancel(id, "Bob");
    house.run(1, Duration.ofMinutes(5));

    assertThat(house.state("G2")).isEqualTo(GoalState.CANCELLED);
    assertThat(house.outcomes.get(id).state()).as(house.told()).isEqualTo(GoalState.CANCELLED);
    assertThat(house.told()).contains("G2 END Cancelled by G1.");
  }

  @Test
  void whatIsKeptEndsAtItsTime() {
    house();
    String id = house.wish("(until \"01:08\" (keep (in Cup zone-a)))");
    house.clock.run(Duration.ofMinutes(7));
    assertThat(house.state("G2")).as(house.told()).isEqualTo(GoalState.HOLDING);
    assertThat(house.status(id).detail()).isEqualTo("G2, until 2026-01-01 01:08");
    house.clock.run(Duration.ofMinutes(2));

    assertThat(house.outcomes.get(id).state()).as(house.told()).isEqualTo(GoalState.ACHIEVED);
    assertThat(house.outcomes.get(id).endedAt()).isEqualTo(Duration.ofMinutes(8));
    assertThat(house.state("G2")).isEqualTo(GoalState.CANCELLED);
    assertThat(house.told())
        .contains("G2 END Cancelled by G1, since it was wanted until 2026-01-01 01:08.");
  }

  @Test
  void whatIsNotReachedByThenHasFailed() {
    house().with("Mug", "zone-c");
    String id = house.wish("(until 3 (in Cup zone-a))");
    house.run(1, Duration.ofMinutes(5));

    assertThat(house.outcomes.get(id).state()).isEqualTo(GoalState.FAILED);
    assertThat(house.outcomes.get(id).reasons().get(0)).contains("It was not so when it ended");
    String reached = house.wish("(until (in Mug zone-b) (in Cup zone-a))");
    house.run(2, Duration.ofMinutes(5));
    assertThat(house.outcomes.get(reached).reached()).as(house.told()).isTrue();
  }

  /** It ends with what it was wanted for, done by whoever it was. */
  @Test
  void whatComesAboutByItsEndIsReached() {
    house().with("Mug", "zone-c");
    String self = house.wish("(until (not (in Cup zone-b)) (after 10 (not (in Cup zone-b))))");
    house.run(1, Duration.ofMinutes(5));
    assertThat(house.outcomes.get(self).state()).as(house.told()).isEqualTo(GoalState.ACHIEVED);
    assertThat(house.told()).doesNotContain("Not reached");

    String before = house.wish("(until (not (in Mug zone-c)) (after 600 (not (in Mug zone-c))))");
    house.clock.run(Duration.ofSeconds(5));
    told("(not (in Mug zone-c))");
    house.run(2, Duration.ofMinutes(1));
    assertThat(house.outcomes.get(before).reasons())
        .containsExactly("It was so when it ended, at or by (not (in Mug zone-c)).");
    assertThat(house.told()).contains(before + " END Reached, but not seen.");
  }

  @Test
  void untilSomethingIsSo() {
    house().with("Mug", "zone-c");
    String id = house.wish("(until (in Mug zone-b) (keep (in Cup zone-a)))");
    house.clock.run(Duration.ofMinutes(10));
    assertThat(house.outcomes).isEmpty();
    told("(in Mug zone-b)");

    assertThat(house.run(1, Duration.ofMinutes(1))).as(house.told()).isTrue();
    assertThat(house.outcomes.get(id).reached()).isTrue();
    String late = house.wish("(until (in Mug zone-b) (keep (in Cup zone-b)))");
    house.run(2, Duration.ofMinutes(1));
    assertThat(house.outcomes.get(late).reasons())
        .containsExactly("It is so already that (in Mug zone-b).");
  }

  @Test
  void eventsAreWhatBecomesSoForEachThing() {
    house().with("Jar", "zone-c").with("Mug", "zone-b");
    String id = house.wish("(whenever (and (Item ?i) (in ?i zone-c)) (fetch ?i))");
    house.clock.run(Duration.ofMinutes(1));
    assertThat(ids()).as("the jar is there already").containsExactly(id);
    assertThat(house.status(id).detail())
        .isEqualTo("for (and (Item ?i) (in ?i zone-c)) to become so");

    house.with("Mug", "zone-c");
    house.with("Mug", "zone-c");
    house.clock.run(Duration.ofMinutes(1));
    assertThat(ids()).as(house.told()).containsExactly("G1", "G2");
    assertThat(house.status("G2").goal()).isEqualTo("(fetch Mug)");
    assertThat(house.place).containsEntry("Mug", "zone-a").containsEntry("Jar", "zone-c");
    assertThat(house.told())
        .contains(
            "So already, which does not count: (and (Item Jar) (in Jar zone-c)).",
            "G2 GOAL Begun by G1, because (and (Item Mug) (in Mug zone-c)) became so.");

    house.with("Mug", "zone-c");
    house.with("Cup", "zone-c");
    house.clock.run(Duration.ofMinutes(2));
    assertThat(ids()).as(house.told()).containsExactly("G1", "G2", "G3", "G4");
    house.coordinator.cancel(id, "Bob");
    house.with("Mug", "zone-c");
    house.clock.run(Duration.ofMinutes(1));
    assertThat(ids()).hasSize(4);
  }

  @Test
  void onceItIsSoIsTheFirstTimeAndNoOther() {
    house().with("Mug", "zone-b").with("Cup", "zone-b");
    String id = house.wish("(once (and (Item ?i) (in ?i zone-c)) (fetch ?i))");
    house.clock.run(Duration.ofMinutes(1));
    assertThat(ids()).containsExactly(id);
    assertThat(house.status(id).detail())
        .isEqualTo("for (and (Item ?i) (in ?i zone-c)) to become so");

    house.with("Mug", "zone-c");
    assertThat(house.run(1, Duration.ofMinutes(2))).as(house.told()).isTrue();

    assertThat(house.outcomes.get(id).reached()).isTrue();
    assertThat(house.place).containsEntry("Mug", "zone-a");
    assertThat(house.told())
        .contains("G2 GOAL Begun by G1, because (and (Item Mug) (in Mug zone-c)) is so.");
    house.with("Cup", "zone-c");
    house.clock.run(Duration.ofMinutes(2));
    assertThat(ids()).as(house.told()).containsExactly("G1", "G2");
  }

  @Test
  void whatIsSoAlreadyIsSoOnce() {
    house().with("Jar", "zone-c");
    String id = house.wish("(once (in ?i zone-c) (keep (in ?i zone-a)))");
    house.clock.run(Duration.ofMinutes(2));

    assertThat(house.place).as(house.told()).containsEntry("Jar", "zone-a");
    assertThat(house.state(id)).isEqualTo(GoalState.RUNNING);
    assertThat(house.coordinator.cancel(id, "Bob")).isTrue();
    house.clock.run(Duration.ofSeconds(1));
    assertThat(house.state("G2")).as("ends with what has begun it").isEqualTo(GoalState.CANCELLED);
  }

  /** What makes itself so again does not keep a processor busy. */
  @Test
  void whatFollowsFromItselfComesOnceASecond() {
    house().with("Mug", "zone-b");
    house.wish("(whenever (in Mug zone-c) (flip))");
    house.clock.run(Duration.ofMillis(10));
    house.with("Mug", "zone-c");
    house.clock.run(Duration.ofSeconds(10));

    assertThat(ids().size()).as(house.told()).isBetween(2, 13);
  }

  @Test
  void oneInAnother() {
    house().with("Mug", "zone-b");
    house.wish("(whenever (in ?i zone-c) (after 30 (until 60 (keep (in ?i zone-a)))))");
    house.clock.run(Duration.ofMillis(10));
    house.with("Mug", "zone-c");
    house.clock.run(Duration.ofSeconds(25));
    assertThat(house.calls).isEmpty();
    house.clock.run(Duration.ofMinutes(3));

    assertThat(house.place).as(house.told()).containsEntry("Mug", "zone-a");
    assertThat(house.status("G2").goal()).isEqualTo("(after 30 (until 60 (keep (in Mug zone-a))))");
    assertThat(house.state("G2")).as(house.told()).isEqualTo(GoalState.ACHIEVED);
    assertThat(house.state("G4")).isEqualTo(GoalState.CANCELLED);
  }

  @Test
  void aTimeThatIsOverIsTold() {
    house();
    String id = house.wish("(at \"2025-12-24 18:00\" (fetch Cup))");
    house.run(1, Duration.ofMinutes(1));

    assertThat(house.outcomes.get(id).reasons())
        .containsExactly("That time was over when it was stated.");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(at \"22:30\" (fetsch Cup))|write (fetch ?item - Item), if that is meant",
        "(at \"22:30\" (in Kup zone-a))|Nobody knows a thing named Kup",
        "(whenever (inn ?i zone-c) (fetch ?i))|The condition",
        "(whenever (in Cup zone-c) (fetch ?i))|The condition says nothing of ?i, which the goal has;"
            + " write a name in its place.",
        "(whenever (in Cup zone-c) (in ?i zone-a))|The condition says nothing of ?i",
        "(once (in Cup zone-c) (in ?i zone-a))|The condition says nothing of ?i",
        "(whenever (> (mass Cup) ?m) (fetch Cup))|The condition leaves the number ?m open",
        "(whenever (in Cup zone-c) (keep (in Cup zone-a)))|What begins again and again has to end;"
            + " write (until \"23:00\" (keep (in Cup zone-a)))",
        "(at \"22:30\" :every \"day\" (at \"23:00\" :every \"day\" (fetch Cup)))|has to end",
        "(at \"22:30\" (fetch zone-a))|zone-a is no Item of this home",
      })
  void badInputGetsOneSentence(String goal, String sentence) {
    house();

    assertThatThrownBy(() -> house.wish(goal))
        .isInstanceOf(InvalidGoalException.class)
        .hasMessageContaining(sentence);
  }
}
