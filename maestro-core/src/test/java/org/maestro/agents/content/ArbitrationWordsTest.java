package org.maestro.agents.content;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ComponentWant;
import org.maestro.coordination.api.GoalPriority;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.sl.Content;

/** What managers of goals and members' agents say to each other of components. */
class ArbitrationWordsTest {
  private static final Duration SENT = Duration.ofSeconds(100);
  private static final Duration READ = Duration.ofSeconds(7);

  private static Words read(Content content) {
    return Words.of(Words.parse(Words.print(content)).get(0));
  }

  private static ComponentWant want(Optional<Duration> deadline) {
    return new ComponentWant(
        "team-1", new GoalPriority(2, 93, deadline, 0), "rose", Set.of("arm", "base"));
  }

  @Test
  void whatIsWantedIsReadAsItWasSaid() {
    assertThat(
            ArbitrationWords.want(read(ArbitrationWords.want(want(Optional.empty()), SENT)), READ))
        .contains(want(Optional.empty()));
  }

  /** Each agent counts from the start of its own clock. */
  @Test
  void aDeadlineIsAsFarAwayForWhoReadsOfIt() {
    ComponentWant said = want(Optional.of(SENT.plusSeconds(60)));

    assertThat(ArbitrationWords.want(read(ArbitrationWords.yieldTo(said, SENT)), READ))
        .contains(want(Optional.of(READ.plusSeconds(60))));
  }

  @Test
  void whatSaysNotWhatIsWantedIsNoWant() {
    assertThat(ArbitrationWords.want(read(ArbitrationWords.wantNoMore("team-1", "rose")), READ))
        .isEmpty();
  }

  @Test
  void aRefusalNamesWhoHasIt() {
    Content refusal = ArbitrationWords.held(new HeldElsewhere("team", "team-1"), "rose");

    assertThat(ArbitrationWords.heldBy(read(refusal)))
        .contains(new HeldElsewhere("team", "team-1"));
    assertThat(Words.print(refusal)).contains("team has what it needs of rose, for team-1");
  }
}
