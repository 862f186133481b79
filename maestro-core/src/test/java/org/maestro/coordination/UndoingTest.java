package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Former;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.undoing.FormerFacts;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** What was so before goals changed it. */
class UndoingTest {
  private static final Duration LONG = Duration.ofMinutes(5);
  private static Home home;

  @BeforeAll
  static void loadHome() throws IOException {
    try (InputStream turtle = UndoingTest.class.getResourceAsStream("/bob.ttl")) {
      home =
          new HomeLoader()
              .load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), "bob.ttl");
    }
  }

  private final PretendHouse house = new PretendHouse(home);
  private final List<Former> told = new ArrayList<>();
  private final List<GoalOutcome> ended = new ArrayList<>();

  private String wish(String goal) {
    return house.coordinator.submit(
        new GoalRequest(SlParser.formula(goal, home.vocabulary()::isFluent), "Bob"), ended::add);
  }

  private String before(String goal) {
    house.coordinator.beforeGoal(goal, List::of, told::add);
    house.clock.runUntil(() -> !told.isEmpty(), LONG);
    return told.get(0).wish().map(SlPrinter::print).orElse("nothing");
  }

  @Test
  void aSettingWasAnotherOne() {
    GoalOutcome dark = house.achieve("(= (level lamp-a1) 0.5)");

    assertThat(before(dark.id())).isEqualTo("(= (level lamp-a1) 1)");
    assertThat(house.achieve("(= (level lamp-a1) 1)").reached()).isTrue();
  }

  @Test
  void whatWasCarriedWasElsewhereAndWhoCarriedItMayStayWhereItIs() {
    GoalOutcome brought = house.achieve("(nextTo Cup Bob)");

    assertThat(brought.reached()).isTrue();
    assertThat(before(brought.id())).contains("(in Cup zone-b)").doesNotContain("(in rose");
  }

  @Test
  void whoWasToGoSomewhereWasElsewhere() {
    GoalOutcome gone = house.achieve("(in rose zone-a)");

    assertThat(before(gone.id())).isEqualTo("(in rose zone-b)");
  }

  @Test
  void nothingWasChangedForWhatWasSoAlready() {
    assertThat(before(house.achieve("(= (level lamp-a1) 1)").id())).isEqualTo("nothing");
  }

  @Test
  void itIsToldOnceWhatWasBegunIsAtRest() {
    house.stepTakes = Duration.ofSeconds(10);
    String dark = wish("(= (level lamp-a1) 0)");
    house.clock.runUntil(() -> house.calls.contains("adjustLight lamp-a1"), LONG);
    house.coordinator.cancel(dark, "Bob");

    assertThat(before(dark)).isEqualTo("(= (level lamp-a1) 1)");
    assertThat(house.level).containsEntry("lamp-a1", 0.0);
  }

  @Test
  void aGoalThatGoesOnIsWaitedFor() {
    String dark = wish("(= (level lamp-a1) 0)");
    house.coordinator.beforeGoal(dark, List::of, told::add);
    house.clock.runUntil(() -> house.calls.contains("adjustLight lamp-a1"), LONG);
    assertThat(told).isEmpty();

    house.clock.runUntil(() -> !told.isEmpty(), LONG);
    assertThat(ended).hasSize(1);
    assertThat(told).extracting(former -> former.wish().isPresent()).containsExactly(true);
  }

  @Test
  void whatWasBegunBeforeARestartIsNotKnown() {
    List<ActionDispatcher.Request> orders = new ArrayList<>();
    house.ordered = orders::add;
    GoalOutcome dark = house.achieve("(= (level lamp-a1) 0)");
    FormerFacts restarted = new FormerFacts(house.knowledge);
    orders.forEach(restarted::begun);

    Former former =
        restarted.before(
            dark.id(), SlParser.formula(dark.goal(), home.vocabulary()::isFluent), List.of());
    assertThat(former.wish()).isEmpty();
    assertThat(former.unknown()).containsExactly("(level lamp-a1)");
  }

  @Test
  void whatIsWantedMeanwhileStaysSo() {
    GoalOutcome dark = house.achieve("(and (= (level lamp-a1) 0) (= (level lamp-a2) 0))");
    house.coordinator.beforeGoal(
        dark.id(),
        () -> List.of(SlParser.formula("(= (level lamp-a1) 0.5)", home.vocabulary()::isFluent)),
        told::add);

    assertThat(told.get(0).wish().map(SlPrinter::print)).contains("(= (level lamp-a2) 1)");
  }
}
