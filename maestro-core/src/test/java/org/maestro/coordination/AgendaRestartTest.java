package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.ontology.home.Home;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** What waits for a time or an event does so after a restart of the coordinator, too. */
class AgendaRestartTest {
  private static final String BRIGHT =
      "(whenever (and (Lamp ?l) (> (level ?l) 0.5)) (= (level ?l) 0.25))";
  private static Home home;

  private final PretendHouse house = new PretendHouse(home);
  private final List<GoalOutcome> outcomes = new ArrayList<>();

  @BeforeAll
  static void loadHome() throws IOException {
    home = RestartTest.bobsHome().in(ZoneId.of("Europe/Berlin"));
  }

  private void submit(String goal) {
    house.coordinator.submit(
        new GoalRequest(
            SlParser.formula(goal, home.vocabulary()::isFluent), "Bob", 0, Optional.empty()),
        outcomes::add);
    house.clock.run(Duration.ofSeconds(1));
  }

  private void restart() {
    house.restart(outcomes::add);
    house.clock.run(Duration.ofSeconds(15));
  }

  private void await(BooleanSupplier condition) {
    assertThat(house.clock.runUntil(condition, Duration.ofMinutes(20))).as(told()).isTrue();
  }

  private String told() {
    return String.join("\n", house.story);
  }

  private List<String> goals() {
    return house.coordinator.goals().stream().map(GoalStatus::goal).toList();
  }

  private String detail() {
    return house.coordinator.goals().get(0).detail();
  }

  private GoalState state(int number) {
    return house.coordinator.goals().get(number - 1).state();
  }

  @Test
  void aTimeThatIsYetToComeComesOnce() {
    submit("(at \"01:05\" (= (level lamp-b1) 0.5))");
    restart();
    assertThat(detail()).isEqualTo("for 2026-01-01 01:05");
    await(() -> !outcomes.isEmpty());

    assertThat(house.clock.now()).isBetween(Duration.ofMinutes(5), Duration.ofSeconds(330));
    assertThat(outcomes.get(0).reached()).as(told()).isTrue();
    assertThat(house.calls).containsOnlyOnce("adjustLight lamp-b1");
    assertThat(goals()).hasSize(2);
    restart();
    assertThat(goals()).as("what is over stays over").hasSize(2);
  }

  /** Clocks of one life and the next differ by parts of a second, and 01:05 is to come once. */
  @Test
  void whatClocksOnTheWallShowIsNotedAsSuch() {
    submit("(at \"01:05\" :every \"day\" (= (level lamp-b1) 0.5))");

    assertThat(house.recovery().goals().get(0).memory().notes())
        .extracting(JournalEntry.Noted::value)
        .containsExactly(Optional.of(new Term.Text("2026-01-01T00:05:00Z")));
  }

  /** It came when the platform was there again, and its devices were not. */
  @Test
  void aTimeThatComesDuringTheComebackIsNotMissed() {
    submit("(after 5 (= (level lamp-b1) 0.5))");
    house.clock.run(Duration.ofSeconds(3));
    restart();

    assertThat(outcomes).as(told()).hasSize(1).allMatch(GoalOutcome::reached);
  }

  @Test
  void whatItHasBegunIsItsOwnAfterARestart() {
    house.stepTakes = Duration.ofSeconds(30);
    submit("(after 5 (= (level lamp-b1) 0.5))");
    await(() -> goals().size() == 2);
    restart();
    assertThat(state(1)).isEqualTo(GoalState.RUNNING);
    assertThat(detail()).isEqualTo("G2");
    await(() -> !outcomes.isEmpty());

    assertThat(outcomes).as(told()).extracting(GoalOutcome::id).contains("G2");
    await(() -> outcomes.size() == 2);
    assertThat(outcomes).allMatch(GoalOutcome::reached);
    assertThat(goals()).hasSize(2);
  }

  @Test
  void whatIsKeptUntilATimeIsKeptAndEnds() {
    submit("(until \"01:02\" (keep (>= (illuminance zone-b) 72)))");
    await(() -> state(2) == GoalState.HOLDING);
    restart();
    assertThat(detail()).isEqualTo("G2, until 2026-01-01 01:02");
    await(() -> outcomes.size() == 2);

    assertThat(house.clock.now()).isEqualTo(Duration.ofMinutes(2));
    assertThat(state(2)).isEqualTo(GoalState.CANCELLED);
    assertThat(state(1)).as(told()).isEqualTo(GoalState.ACHIEVED);
  }

  @Test
  void whatIsCancelledDuringTheComebackEndsWithAllThatItHasBegun() {
    submit("(until \"01:30\" (keep (>= (illuminance zone-b) 72)))");
    await(() -> state(2) == GoalState.HOLDING);
    house.restart(outcomes::add);
    house.coordinator.cancel("G1", "Bob");
    await(() -> outcomes.size() == 2);

    assertThat(state(1)).isEqualTo(GoalState.CANCELLED);
    assertThat(state(2)).isEqualTo(GoalState.CANCELLED);
  }

  @Test
  void whatWasSoBeforeIsNoEventAfterwards() {
    house.setLevel("lamp-b1", 1);
    submit(BRIGHT);
    restart();
    restart();

    assertThat(goals()).as(told()).hasSize(1);
    assertThat(told()).doesNotContain("Missed");
    house.setLevel("lamp-b1", 0);
    house.clock.run(Duration.ofSeconds(1));
    house.setLevel("lamp-b1", 1);
    await(() -> goals().size() == 2);
    assertThat(goals().get(1)).isEqualTo("(= (level lamp-b1) 0.25)");
  }

  /** Each has a note of its own, whatever was noted before. */
  @Test
  void whatBecomesSoAfterARestartTakesNothingOfWhatIsSoStill() {
    house.setLevel("lamp-b1", 1);
    house.setLevel("lamp-b2", 1);
    submit(BRIGHT.replace("0.25", "0.75"));
    house.setLevel("lamp-b1", 0);
    house.clock.run(Duration.ofSeconds(1));
    restart();
    house.setLevel("lamp-b3", 1);
    await(() -> goals().size() == 2);
    house.setLevel("lamp-b1", 1);
    await(() -> goals().size() == 3);
    house.clock.run(Duration.ofSeconds(10));
    restart();

    assertThat(told()).doesNotContain("Missed");
    assertThat(goals()).hasSize(3);
  }

  @Test
  void anEventThatNobodyWatchedIsToldAndNotDone() {
    submit(BRIGHT);
    house.setLevel("lamp-b1", 1);
    restart();

    assertThat(goals()).as(told()).hasSize(1);
    assertThat(told())
        .contains(
            "Missed while no platform ran, and not done: (and (Lamp lamp-b1) (> (level lamp-b1)"
                + " 0.5)) became so.");
    assertThat(detail()).contains("; missed: (and (Lamp lamp-b1)");
  }

  @Test
  void whatIsSoOnceNobodyWatchedComesLateAndIsNotLost() {
    submit("(once (> (level lamp-b1) 0.5) (= (level lamp-b2) 0.5))");
    house.setLevel("lamp-b1", 1);
    restart();
    await(() -> !outcomes.isEmpty());

    assertThat(outcomes).as(told()).hasSize(1).allMatch(GoalOutcome::reached);
    assertThat(state(2)).isEqualTo(GoalState.ACHIEVED);
    restart();
    assertThat(goals()).as("what is over stays over").hasSize(2);
  }

  @Test
  void whatHasBegunOnceItWasSoIsFollowedAfterARestart() {
    house.stepTakes = Duration.ofSeconds(30);
    house.setLevel("lamp-b1", 1);
    submit("(once (> (level lamp-b1) 0.5) (= (level lamp-b2) 0.5))");
    await(() -> goals().size() == 2);
    restart();
    await(() -> outcomes.size() == 2);

    assertThat(outcomes).as(told()).allMatch(GoalOutcome::reached);
    assertThat(goals()).hasSize(2);
  }

  @Test
  void whoIsLostAndComesBackIsNoEvent() {
    house.setLevel("lamp-b1", 1);
    submit(BRIGHT);
    house.coordinator.memberLost("lamp-b1", "no power");
    house.clock.run(Duration.ofSeconds(1));
    house.coordinator.memberPresent("lamp-b1");
    house.setLevel("lamp-b1", 1);
    house.clock.run(Duration.ofSeconds(1));

    assertThat(goals()).as(told()).hasSize(1);
  }
}
