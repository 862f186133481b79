package org.maestro.agents.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Whose work is done next. */
class PlanningTurnsTest {
  private static final long LATER = 1_000;

  private final PlanningTurns turns = new PlanningTurns();
  private final List<String> done = new ArrayList<>();
  private int waiting;

  @Test
  void whoAsksForFewDoesNotWaitForAllOfWhoAsksForMany() {
    for (int number = 1; number <= 4; number++) {
      add("many", number, 0);
    }
    add("few", 1, 0);
    add("few", 2, 0);

    assertThat(allAt(0)).containsExactly("many 1", "few 1", "many 2", "few 2", "many 3", "many 4");
  }

  @Test
  void whoComesLaterComesAfterThoseWhoWait() {
    add("first", 1, 0);
    add("first", 2, 0);
    add("second", 1, 0);
    next(0);
    add("third", 1, 0);

    assertThat(allAt(0)).containsExactly("first 1", "second 1", "first 2", "third 1");
  }

  @Test
  void whatCanWaitIsOvertakenUntilItsTimeHasCome() {
    add("patient", 1, LATER);
    add("other", 1, 0);
    add("other", 2, 0);

    next(0);
    assertThat(done).containsExactly("other 1");
    next(LATER);
    assertThat(done).containsExactly("other 1", "patient 1");
  }

  @Test
  void ofOneWhoAsksWhatIsDueFirstIsDoneFirst() {
    add("one", 1, LATER);
    add("one", 2, 0);
    add("one", 3, LATER);

    assertThat(allAt(0)).containsExactly("one 2", "one 1", "one 3");
  }

  @Test
  void whereAllCanWaitTheEarliestIsDone() {
    add("one", 1, 2 * LATER);
    add("two", 1, LATER);
    add("three", 1, 3 * LATER);

    assertThat(allAt(0)).containsExactly("two 1", "one 1", "three 1");
  }

  private void add(String requester, int number, long dueNanos) {
    turns.add(() -> done.add(requester + " " + number), requester, dueNanos);
    waiting++;
  }

  private void next(long nowNanos) {
    turns.next(nowNanos).run();
    waiting--;
  }

  private List<String> allAt(long nowNanos) {
    while (waiting > 0) {
      next(nowNanos);
    }
    return done;
  }
}
