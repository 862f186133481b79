package org.maestro.persons.visits;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.habits.HabitLog;

/** Dave comes home through the hallway, from which six ways lead on. */
class PassagesTest {
  private static final Instant MONDAY_EVENING = Instant.parse("2026-11-23T18:00:00Z");
  private static final ZoneId ZONE = ZoneOffset.UTC;
  private static final int WAYS = 6;

  private final List<String> kept = new ArrayList<>();
  private final HabitLog log =
      new HabitLog() {
        @Override
        public List<String> lines() {
          return List.copyOf(kept);
        }

        @Override
        public void add(String line) {
          kept.add(line);
        }
      };
  private final Passages passages = new Passages(log);

  private void evenings(int number, String from, String next) {
    for (int day = 0; day < number; day++) {
      passages.add(
          new Passage(MONDAY_EVENING.plus(Duration.ofDays(day)), "Dave", from, "hallway", next));
    }
  }

  private Optional<Passages.Next> next(Passages counted, String from, Instant when) {
    return counted.next("Dave", from, "hallway", WAYS, when, ZONE);
  }

  @Test
  void beforeTheFirstTimeNothingIsForetold() {
    assertThat(next(passages, "garden", MONDAY_EVENING)).isEmpty();
  }

  @Test
  void whoWentThereEachEveningWillGoThereAgainTheSurerTheOftener() {
    evenings(1, "garden", "livingroom");
    double once = next(passages, "garden", MONDAY_EVENING).orElseThrow().probability();
    evenings(4, "garden", "livingroom");
    Passages.Next often = next(passages, "garden", MONDAY_EVENING).orElseThrow();

    assertThat(once).isLessThan(0.7);
    assertThat(often.place()).isEqualTo("livingroom");
    assertThat(often.probability()).isGreaterThan(0.8).isLessThan(0.95);
  }

  @Test
  void whoCameAnotherWayMayGoElsewhere() {
    evenings(5, "garden", "livingroom");
    evenings(5, "bedroom", "bathroom");

    assertThat(next(passages, "garden", MONDAY_EVENING).orElseThrow().place())
        .isEqualTo("livingroom");
    assertThat(next(passages, "bedroom", MONDAY_EVENING).orElseThrow().place())
        .isEqualTo("bathroom");
    assertThat(next(passages, "kitchen", MONDAY_EVENING).orElseThrow().probability())
        .isLessThan(0.7);
  }

  @Test
  void eveningsTellNothingOfMorningsAndWorkingDaysNothingOfWeekends() {
    evenings(5, "garden", "livingroom");

    assertThat(next(passages, "garden", Instant.parse("2026-11-30T17:00:00Z"))).isPresent();
    assertThat(next(passages, "garden", Instant.parse("2026-11-30T08:00:00Z"))).isEmpty();
    assertThat(next(passages, "garden", Instant.parse("2026-11-29T18:00:00Z"))).isEmpty();
  }

  @Test
  void whoMostlyStayedIsHeadingNowhere() {
    evenings(5, "garden", "hallway");
    evenings(1, "garden", "livingroom");

    assertThat(next(passages, "garden", MONDAY_EVENING)).isEmpty();
  }

  @Test
  void whatWasCountedIsTakenUpAgainButForDamagedAndVeryOldLines() {
    evenings(5, "garden", "livingroom");
    kept.add(2, "no passage");
    kept.add("2026-01-05T18:00:00Z Dave garden hallway kitchen");
    Passages again = new Passages(log);
    again.begin(MONDAY_EVENING.plus(Duration.ofDays(7)));

    assertThat(next(again, "garden", MONDAY_EVENING.plus(Duration.ofDays(7))))
        .isEqualTo(next(passages, "garden", MONDAY_EVENING.plus(Duration.ofDays(7))))
        .isPresent();
  }
}
