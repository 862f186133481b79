package org.maestro.diary;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.language.Language;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/** What is told of a day is what was noted in it, by the home's clocks (ADE, 5; A70). */
class DiaryTest {
  private static final Path HOME =
      Path.of("../scenarios/assembly/src/main/resources/homes/livingroom.ttl");

  /** In the home's time zone; the clock begins at one in the morning there. */
  private static final LocalDate FIRST = LocalDate.parse("2026-01-01");

  private static Home home;

  @TempDir private Path directory;

  private final SteppedClock clock = new SteppedClock();

  @BeforeAll
  static void load() throws IOException {
    home =
        new HomeLoader()
            .load(
                Files.readString(HOME)
                    + "\n<https://w3id.org/maestro/home/livingroom> maestro:timeZone \"Europe/Berlin\" .\n",
                "livingroom.ttl");
  }

  private Diary diary() {
    Diary diary = new Diary(() -> home, clock, Optional.of(directory));
    diary.begin();
    return diary;
  }

  private void wait(Duration time) {
    clock.run(time);
  }

  private static void note(Diary diary, String... facts) {
    diary.note(
        new KnowledgeBase.Change(1, new Source(Source.Kind.OBSERVED, "camera"), List.of(facts)));
  }

  private void ask(Diary diary, String id, String goal, String requester) {
    diary.note(
        new JournalEntry.Submitted(
            id, new GoalRequest(SlParser.formula(goal, home.vocabulary()::isFluent), requester)));
  }

  private static void end(Diary diary, String id, GoalState state, String... reasons) {
    diary.note(
        new JournalEntry.Over(
            new GoalOutcome(
                id,
                "",
                state,
                true,
                Map.of(),
                List.of(reasons),
                1,
                0,
                Duration.ZERO,
                Duration.ZERO,
                0)));
  }

  private static List<String> told(DayReport report) {
    return new DaySentences(home, home.timeZone().orElseThrow(), Language.of(home, "en").grammar())
        .of(report).stream()
            .map(
                told ->
                    Stream.of(told.from().toString(), told.to().map(Object::toString).orElse(""))
                            .toList()
                        + " "
                        + told.text())
            .toList();
  }

  @Test
  void theDayIsInSentencesInTheOrderOfTime() {
    Diary diary = diary();
    wait(Duration.ofHours(1));
    note(diary, "(in Dave livingroom)", "(not (in Dave bedroom))", "(canSee lux Dave)");
    note(diary, "(= (level lamp-1) 1)");
    wait(Duration.ofMinutes(10));
    ask(diary, "G1", "(= (level lamp-1) 0.5)", "desk for Dave");
    note(diary, "(= (level lamp-1) 0.5)", "(= (illuminance livingroom) 93)");
    end(diary, "G1", GoalState.ACHIEVED);
    wait(Duration.ofMinutes(10));
    note(diary, "(unknown (in Dave livingroom))");
    wait(Duration.ofSeconds(40));
    note(diary, "(in Dave livingroom)", "(in Eve bedroom)");
    wait(Duration.ofMinutes(5));
    ask(diary, "G2", "(switchedOn television)", "porch");
    note(diary, "(in Dave bedroom)", "(not (in Dave livingroom))");
    wait(Duration.ofMinutes(1));
    end(diary, "G2", GoalState.FAILED, "television is lost.");
    note(diary, "(unknown (in Dave bedroom))");
    wait(Duration.ofHours(1));
    ask(diary, "G3", "(survey Eve)", "desk");

    DayReport report = diary.report("Dave", FIRST, Set.of()).orElseThrow();

    assertThat(told(report))
        .containsExactly(
            "[00:00, 02:00] Nobody knows where Dave is.",
            "[02:00, 02:25:40] Dave is in the living room.",
            "[02:10, ] Dave asks me to see to it that the level of the left lamp is 50 percent.",
            "[02:10, ] The level of the left lamp is 50 percent.",
            "[02:10, ] As was asked: The level of the left lamp is 50 percent.",
            "[02:25:40, 02:26:40] Dave is in the bedroom.",
            "[02:25:40, ] Somebody asks me to turn on the television.",
            "[02:26:40, 03:26:40] Nobody knows where Dave is.",
            "[02:26:40, ] I could not turn on the television. The television is lost.",
            "[03:26:40, ] Somebody asks me to ask somebody how the evening was.");
    assertThat(report.requests().get(2).end()).isEmpty();
    assertThat(report.until()).isEqualTo(clock.instant());
    diary.close();
  }

  @Test
  void eachDayHasAFileAndBeginsWithWhatWasSo() {
    Diary diary = diary();
    wait(Duration.ofHours(22));
    note(diary, "(in Dave livingroom)", "(switchedOn television)");
    wait(Duration.ofHours(2));
    note(diary, "(in Dave bedroom)");
    diary.close();
    wait(Duration.ofHours(1));

    Diary next = new Diary(() -> home, clock, Optional.of(directory));
    DayReport first = next.report("Dave", FIRST, Set.of()).orElseThrow();
    DayReport second = next.report("Dave", FIRST.plusDays(1), Set.of()).orElseThrow();

    assertThat(first.stays())
        .extracting(DayReport.Stay::zone, stay -> hours(stay.from()), stay -> hours(stay.to()))
        .containsExactly(tuple("livingroom", 22L, 23L));
    assertThat(second.stays())
        .extracting(DayReport.Stay::zone, stay -> hours(stay.from()), stay -> hours(stay.to()))
        .containsExactly(tuple("livingroom", 23L, 24L), tuple("bedroom", 24L, 25L));
    assertThat(next.report("Dave", FIRST.minusDays(1), Set.of())).isEmpty();
  }

  private long hours(Instant at) {
    return Duration.between(clock.start(), at).toHours();
  }

  /** What was so before a restart was so as long as something was told, and no longer. */
  @Test
  void nothingIsClaimedOfTheTimeWithoutAPlatform() throws IOException {
    Diary before = diary();
    note(before, "(in Dave livingroom)");
    wait(Duration.ofMinutes(20));
    note(before, "(= (level lamp-1) 1)");
    wait(Duration.ofMinutes(20));
    Files.writeString(
        directory.resolve(FIRST + ".jsonl"), "{\"at\":\"2026-01-", StandardOpenOption.APPEND);
    Diary after = diary();
    wait(Duration.ofMinutes(5));
    note(after, "(in Dave livingroom)");
    wait(Duration.ofMinutes(5));

    DayReport report = after.report("Dave", FIRST, Set.of()).orElseThrow();

    assertThat(report.stays())
        .extracting(stay -> minutes(stay.from()), stay -> minutes(stay.to()))
        .containsExactly(tuple(0L, 20L), tuple(45L, 50L));
    assertThat(report.silences())
        .extracting(one -> minutes(one.from()), one -> minutes(one.to()))
        .containsExactly(tuple(-60L, 0L), tuple(20L, 45L));
  }

  private long minutes(Instant at) {
    return Duration.between(clock.start(), at).toMinutes();
  }

  @Test
  void whatIsPrivateIsLeftOutAndCounted() {
    Diary diary = diary();
    note(diary, "(in Dave livingroom)", "(not (switchedOn television))");
    note(diary, "(switchedOn television)");
    ask(diary, "G1", "(queryPrefs livingroom Dave \"TV show\" 600)", "desk for Dave");
    end(diary, "G1", GoalState.ACHIEVED);

    DayReport all = diary.report("Dave", FIRST, Set.of()).orElseThrow();
    DayReport some = diary.report("Dave", FIRST, Set.of("in", "prefers")).orElseThrow();

    assertThat(all.requests()).hasSize(1);
    assertThat(all.leftOut()).isZero();
    assertThat(some.requests()).isEmpty();
    assertThat(some.stays()).isEmpty();
    assertThat(some.changes()).hasSize(1);
    assertThat(some.leftOut()).isEqualTo(2);
  }

  @Test
  void whatIsTheSameStillIsNotedOnceAndHowItWasAtFirstIsNoChange() throws IOException {
    Diary diary = diary();
    for (int i = 0; i < 100; i++) {
      note(diary, "(in Dave livingroom)", "(not (in Dave bedroom))", "(switchedOn television)");
      wait(Duration.ofSeconds(1));
    }
    assertThat(diary.report("Dave", FIRST, Set.of()).orElseThrow().changes()).isEmpty();
    assertThat(Files.readString(directory.resolve(FIRST + ".jsonl")).lines())
        .filteredOn(line -> !line.isBlank())
        .hasSize(3);
  }

  @Test
  void ofWhatChangesAgainAndAgainBeginAndEndAreTold() {
    Diary diary = diary();
    note(diary, "(= (level lamp-1) 1)");
    wait(Duration.ofMinutes(1));
    for (int percent = 99; percent >= 0; percent--) {
      note(diary, "(= (level lamp-1) %s)".formatted(percent / 100.0));
      wait(Duration.ofSeconds(1));
    }
    wait(Duration.ofMinutes(1));
    note(diary, "(= (level lamp-1) 1)");

    assertThat(diary.report("Dave", FIRST, Set.of()).orElseThrow().changes())
        .extracting(DayReport.Change::fact)
        .containsExactly(
            "(= (level lamp-1) 0.99)", "(= (level lamp-1) 0.0)", "(= (level lamp-1) 1)");
  }
}
