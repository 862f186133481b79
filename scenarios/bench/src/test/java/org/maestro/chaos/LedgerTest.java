package org.maestro.chaos;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.api.StepKey;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/** What a journal may not lack is missed. */
class LedgerTest {
  private final Ledger ledger = new Ledger(1);
  private Journal journal;

  @BeforeEach
  void open() throws IOException {
    try (var turtle = LedgerTest.class.getResourceAsStream("/homes/bob.ttl")) {
      String text = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      journal = ledger.begin(new HomeLoader().load(text, "bob.ttl"), new SteppedClock());
    }
  }

  @AfterEach
  void close() {
    ledger.close();
  }

  @Test
  void nothingIsMissedWhereAllIsWritten() {
    accept("G1");
    journal.write(begun());
    journal.write(new JournalEntry.Ended("G1", "C1", Optional.empty()));
    over(GoalState.ACHIEVED);
    ledger.ended(outcome(GoalState.ACHIEVED));
    assertThat(ledger.findings()).isEmpty();
  }

  @Test
  void aGoalThatIsNotThereIs() {
    accept("G1");
    ledger.accepted("G2");
    assertFinding("LOST G2");
  }

  @Test
  void soIsAnEndThatWasTold() {
    accept("G1");
    ledger.ended(outcome(GoalState.ACHIEVED));
    assertFinding("OTHER_END G1");
  }

  @Test
  void andOneThatWasToldOtherwise() {
    accept("G1");
    over(GoalState.FAILED);
    ledger.ended(outcome(GoalState.ACHIEVED));
    assertFinding("OTHER_END G1");
  }

  @Test
  void andTheEndOfACall() {
    accept("G1");
    journal.write(begun());
    over(GoalState.ACHIEVED);
    ledger.ended(outcome(GoalState.ACHIEVED));
    assertFinding("OPEN_CALL C1");
  }

  private void assertFinding(String beginning) {
    assertThat(ledger.findings()).singleElement().asString().startsWith(beginning);
  }

  private void accept(String id) {
    journal.accept(
        new JournalEntry.Submitted(
            id, new GoalRequest(SlParser.formula("(in Cup rose)", "level"::equals), "Bob")),
        () -> ledger.accepted(id),
        refused -> assertThat(refused).isEmpty());
  }

  private void over(GoalState state) {
    journal.write(new JournalEntry.Over(outcome(state)));
  }

  private static GoalOutcome outcome(GoalState state) {
    return new GoalOutcome(
        "G1",
        "(in Cup rose)",
        state,
        true,
        Map.of(),
        List.of(),
        1,
        0,
        Duration.ZERO,
        Duration.ofSeconds(1),
        0);
  }

  private static JournalEntry.Begun begun() {
    return new JournalEntry.Begun(
        "G1",
        new ActionDispatcher.Call("C1", Optional.empty()),
        new StepKey("rose", "pick", Map.of()),
        1,
        4,
        Map.of(),
        Duration.ofSeconds(10));
  }
}
