package org.maestro.agents.centre;

import static org.assertj.core.api.Assertions.assertThat;

import jade.core.AID;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.Words;
import org.maestro.sl.Content;

class GoalsOfOthersTest {
  private static final int MANY = 10_000;
  private static final AID ANNA = new AID("anna@home", AID.ISGUID);

  private final GoalsOfOthers goals = new GoalsOfOthers();

  private void told(String id, String state) {
    goals.told(ANNA, id, state, status(id, state, "in peace"));
  }

  private static Content status(String id, String state, String detail) {
    return Words.content(
        "inform",
        Words.named("goal", Words.name(id)),
        Words.named("state", Words.name(state)),
        Words.named("detail", Words.text(detail)));
  }

  @Test
  void ofThoseThatAreOverTheLatestAreKeptAndAllThatAreNot() {
    told("anna-1", "holding");
    for (int number = 2; number <= MANY; number++) {
      told("anna-" + number, "running");
      told("anna-" + number, "achieved");
    }

    assertThat(goals.owner("anna-1")).contains(ANNA);
    assertThat(goals.owner("anna-" + MANY)).contains(ANNA);
    assertThat(goals.owner("anna-2")).isEmpty();
    assertThat(goals.statuses())
        .hasSizeBetween(50, 200)
        .last()
        .isEqualTo(status("anna-1", "holding", "in peace"));
  }

  @Test
  void whatEachSaysCountsByItsLength() {
    String words = "x".repeat(50_000);
    IntStream.rangeClosed(1, 100)
        .forEach(
            number -> goals.told(ANNA, "a-" + number, "running", status("a", "running", words)));

    assertThat(goals.statuses()).hasSizeBetween(5, 10);
  }

  @Test
  void ofEachWhatItSaidLastIsTold() {
    told("anna-1", "running");
    told("anna-1", "waiting");
    told("anna-1", "failed");
    told("anna-1", "cancelled");

    assertThat(goals.statuses()).containsExactly(status("anna-1", "cancelled", "in peace"));
  }
}
