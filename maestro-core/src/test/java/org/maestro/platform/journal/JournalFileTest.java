package org.maestro.platform.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.GoalEffort;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.journal.JournalImage;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.planning.api.StepKey;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

class JournalFileTest {
  @TempDir private Path directory;
  private final SteppedClock clock = new SteppedClock();

  private JournalFile open(Clock with) {
    return JournalFile.open(directory.resolve("data"), with, "level"::equals);
  }

  private Path file() {
    return directory.resolve("data").resolve("journal.jsonl");
  }

  private Path mark() {
    return file().resolveSibling("journal.mark");
  }

  private static GoalRequest request(String goal) {
    return new GoalRequest(SlParser.formula(goal, "level"::equals), "Bob");
  }

  private static JournalEntry.Begun begun(String goal, int number) {
    return new JournalEntry.Begun(
        goal,
        new ActionDispatcher.Call(goal + "-x-" + number, Optional.of("boot@maestro")),
        new StepKey("rose", "pick", Map.of("object", new Term.Name("Cup"))),
        number,
        2.5,
        Map.of(
            "object",
            new Argument(
                new Term.Name("Cup"),
                Optional.of("urn:home#Cup"),
                Map.of("position", List.of(new Term.Text("1.25 2 0"), new Term.Number(0.1)))),
            "zone",
            new Argument(new Term.Truth(true), Optional.empty(), Map.of())),
        Duration.ofMillis(15_500));
  }

  private static JournalEntry.Over over(String goal, GoalState state) {
    return new JournalEntry.Over(
        new GoalOutcome(
            goal,
            "(nextTo Cup \"Bob\")",
            state,
            true,
            Map.of("agent", new Term.Name("cam-b")),
            List.of("It was \"dark\"."),
            3,
            1,
            Duration.ofSeconds(1),
            Duration.ofSeconds(5),
            12.5));
  }

  private static List<JournalEntry> entries() {
    return List.of(
        new JournalEntry.MemberCame("rose", Optional.of("boot@maestro")),
        new JournalEntry.MemberCame("tim", Optional.empty()),
        new JournalEntry.MemberWent("tim", "its battery is empty"),
        new JournalEntry.Submitted("G1", request("(and (nextTo Cup Bob) (>= (level lamp) 0.5))")),
        new JournalEntry.Submitted(
            "G2",
            new GoalRequest(
                SlParser.formula("(exists (?z - Zone) (in Cup ?z))"),
                "Anna",
                7,
                Optional.of(Duration.ofSeconds(90)),
                Optional.of(
                    new Stakes(
                        SlParser.expression("(+ 40 (level lamp))"),
                        0.5,
                        Optional.of(Duration.ofMinutes(5)),
                        2,
                        4)))),
        new JournalEntry.Became("G1", GoalState.RUNNING, "", new GoalEffort(2, 1, 0)),
        new JournalEntry.Keeps(
            "G1",
            Set.of(Resource.component("rose", "arm"), Resource.component("rose", "base")),
            Set.of((Formula.Atom) SlParser.formula("(in Cup rose)")),
            Map.of("in", Set.of("Cup", "rose"), "open", Set.of(""))),
        begun("G1", 1),
        begun("G1", 2),
        begun("G1", 3),
        new JournalEntry.Ended("G1", "G1-x-1", Optional.of("it slipped")),
        new JournalEntry.Established("G1", "G1-x-2"),
        new JournalEntry.CalledOff("G1", "G1-x-3"),
        new JournalEntry.Submitted("G3", request("(in Cup rose)")),
        over("G3", GoalState.FAILED));
  }

  private Recovery written(List<JournalEntry> entries) {
    try (JournalFile journal = open(clock)) {
      entries.forEach(journal::write);
    }
    try (JournalFile journal = open(clock)) {
      return journal.recovery();
    }
  }

  @Test
  void tellsTheNextCoordinatorAllThatItHasToKnow() {
    Recovery recovery = written(entries());

    assertThat(recovery.lastGoalNumber()).isEqualTo(3);
    assertThat(recovery.members()).containsExactly("rose");
    assertThat(recovery.goals())
        .extracting(Recovery.UnfinishedGoal::id)
        .containsExactly("G1", "G2");
    Recovery.UnfinishedGoal first = recovery.goals().get(0);
    assertThat(first.request()).isEqualTo(request("(and (nextTo Cup Bob) (>= (level lamp) 0.5))"));
    assertThat(first.effort()).isEqualTo(new GoalEffort(2, 1, 3));
    assertThat(first.state()).isEqualTo(GoalState.RUNNING);
    assertThat(first.keeps()).isEqualTo(entries().get(6));
    assertThat(first.calls())
        .containsExactly(new Recovery.UnfinishedCall(begun("G1", 2), Duration.ZERO, true));
    assertThat(recovery.unwanted()).extracting(call -> call.begun().number()).containsExactly(3);
    assertThat(recovery.goals().get(1).request())
        .isEqualTo(((JournalEntry.Submitted) entries().get(4)).request());
    assertThat(recovery.ended()).extracting(Recovery.EndedGoal::request).hasSize(1);
    GoalOutcome ended = ((JournalEntry.Over) entries().get(14)).outcome();
    assertThat(recovery.ended().get(0).outcome())
        .usingRecursiveComparison()
        .ignoringFields("endedAt")
        .isEqualTo(ended);
  }

  private static List<JournalEntry> lessons() {
    StepKey look =
        new StepKey(
            "cam-b", "observe", Map.of("object", new Term.Name("Cup"), "n", new Term.Number(0.25)));
    return List.of(
        new JournalEntry.Submitted("rose-1", request("(keep (>= (level lamp) 0.5))")),
        new JournalEntry.Became("rose-1", GoalState.HOLDING, "", new GoalEffort(0, 0, 0)),
        new JournalEntry.Became("rose-1", GoalState.WAITING, "", new GoalEffort(0, 0, 0)),
        new JournalEntry.Failed(
            "rose-1", look, "(in Cup b)=UNKNOWN", 1, 2, "too \"dark\"", List.of()),
        new JournalEntry.Failed(
            "rose-1",
            look,
            "(in Cup b)=UNKNOWN",
            2,
            3,
            "still too dark",
            List.of(new FeatureRun.Learnt("(mass Cup)", new Term.Number(2.5)))),
        new JournalEntry.LookedInVain(
            "rose-1",
            look,
            (Formula.Atom) SlParser.formula("(in Cup zone-b)"),
            new SearchReport.Look(
                "zone-b", "cam-b", Duration.ofMillis(1_250), OptionalDouble.of(0.97))),
        new JournalEntry.Settings(
            "rose-1",
            List.of(
                new JournalEntry.Setting(
                    (Expression.Fluent) SlParser.expression("(level lamp)"), 0.25, 1, look))),
        new JournalEntry.Asked("rose-1", "G7", SlParser.formula("(in Cup rose)")));
  }

  @Test
  void tellsWhatAGoalHasLearnt() {
    List<JournalEntry> lessons = lessons();

    Recovery.GoalMemory memory = written(lessons).goals().get(0).memory();

    assertThat(memory.everHeld()).isTrue();
    assertThat(memory.failures()).isEqualTo(List.of(lessons.get(4)));
    assertThat(memory.looks()).isEqualTo(List.of(lessons.get(5)));
    assertThat(memory.settings()).isEqualTo(((JournalEntry.Settings) lessons.get(6)).settings());
    assertThat(memory.asked()).contains((JournalEntry.Asked) lessons.get(7));
    assertThat(written(List.of()).goals().get(0).memory()).isEqualTo(memory);
    Recovery later = written(List.of(new JournalEntry.AttemptOver("rose-1")));
    assertThat(later.goals().get(0).memory().failures()).isEmpty();
    assertThat(later.goals().get(0).memory().everHeld()).isTrue();
  }

  @Test
  void tellsEachCoordinatorOfItsOwnGoals() {
    List<JournalEntry> all = new ArrayList<>(entries());
    all.addAll(lessons());
    Recovery recovery = written(all);

    assertThat(recovery.of("G").goals())
        .extracting(Recovery.UnfinishedGoal::id)
        .containsExactly("G1", "G2");
    assertThat(recovery.of("rose-").goals())
        .extracting(Recovery.UnfinishedGoal::id)
        .containsExactly("rose-1");
    assertThat(recovery.of("rose-").lastGoalNumber()).isEqualTo(1);
    assertThat(recovery.of("G").lastGoalNumber()).isEqualTo(3);
  }

  @Test
  void canBeMadeAgainFromWhatItTells() {
    List<JournalEntry> all = new ArrayList<>(entries());
    all.addAll(lessons());
    Recovery recovery = written(all);

    assertThat(JournalImage.of(recovery, clock.now()).recovery()).isEqualTo(recovery);
  }

  @Test
  void saysTheSameWhenItIsOpenedAgainAndAgain() {
    Recovery first = written(entries());

    assertThat(written(List.of())).isEqualTo(first);
    assertThat(written(List.of())).isEqualTo(first);
  }

  @Test
  void isReadByPeople() throws IOException {
    written(entries());

    assertThat(Files.readAllLines(file()))
        .anyMatch(line -> line.contains("\"event\":\"begun\",\"goal\":\"G1\",\"call\":\"G1-x-2\""))
        .allMatch(line -> line.startsWith("{\"n\":") && line.endsWith("\"}"));
  }

  @Test
  void leavesALineAwayThatWasNotWrittenToItsEnd() throws IOException {
    Recovery before = written(entries());
    byte[] whole = Files.readAllBytes(file());
    byte[] mark;
    try (JournalFile journal = open(clock)) {
      mark = Files.readAllBytes(mark());
      journal.write(new JournalEntry.Submitted("G4", request("(in Cup rose)")));
    }
    byte[] longer = Files.readAllBytes(file());
    for (int length = whole.length; length < longer.length - 1; length += 9) {
      Files.write(file(), Arrays.copyOf(longer, length));
      Files.write(mark(), mark);
      try (JournalFile journal = open(clock)) {
        assertThat(journal.recovery()).as(length + " bytes").isEqualTo(before);
      }
    }
    Files.write(file(), Arrays.copyOf(longer, longer.length - 1));
    Files.write(mark(), mark);
    try (JournalFile journal = open(clock)) {
      assertThat(journal.recovery().goals()).hasSize(3);
    }
  }

  @Test
  void namesADamagedLine() throws IOException {
    written(entries());
    List<String> lines = Files.readAllLines(file());
    List<String> changed = new ArrayList<>(lines);
    changed.set(2, changed.get(2).replace("Cup", "Cap"));
    Files.write(file(), changed);
    assertThatThrownBy(() -> open(clock))
        .isInstanceOf(PlatformStartException.class)
        .hasMessageContaining(file().toString())
        .hasMessageContaining("line 3")
        .hasMessageContaining("checksum")
        .hasMessageContaining("move the file away");

    List<String> fewer = new ArrayList<>(lines);
    fewer.remove(3);
    Files.write(file(), fewer);
    assertThatThrownBy(() -> open(clock))
        .hasMessageContaining("line 4")
        .hasMessageContaining("missing");

    Files.write(file(), lines);
    open(clock).close();
  }

  @Test
  void belongsToOneAtATime() {
    try (JournalFile journal = open(clock)) {
      assertThatThrownBy(() -> open(clock))
          .isInstanceOf(PlatformStartException.class)
          .hasMessageContaining("in use")
          .hasMessageContaining(String.valueOf(ProcessHandle.current().pid()));
      assertThat(journal.recovery()).isEqualTo(Recovery.NOTHING);
    }
    open(clock).close();
  }

  @Test
  void takesAHundredGoalsInASecond() throws InterruptedException {
    List<Integer> order = new ArrayList<>();
    CountDownLatch answered = new CountDownLatch(100);
    try (PacedClock paced = new PacedClock(1);
        JournalFile journal = open(paced)) {
      long began = System.nanoTime();
      for (int number = 1; number <= 100; number++) {
        int goal = number;
        journal.write(new JournalEntry.Submitted("G" + goal, request("(in Cup rose)")));
        journal.write(begun("G" + goal, 1));
        journal.afterwards(
            () -> {
              order.add(goal);
              answered.countDown();
            });
      }
      assertThat(answered.await(20, TimeUnit.SECONDS)).isTrue();
      assertThat(order).isSorted().hasSize(100);
      assertThat(Duration.ofNanos(System.nanoTime() - began)).isLessThan(Duration.ofSeconds(5));
    }
    assertThat(written(List.of()).goals()).hasSize(100);
  }

  @Test
  void doesNotGrowForEver() throws IOException {
    try (JournalFile journal = open(clock)) {
      journal.write(new JournalEntry.Submitted("G1", request("(in Cup rose)")));
      for (int round = 0; round < 22; round++) {
        for (int number = 0; number < 2_000; number++) {
          journal.write(
              new JournalEntry.Became(
                  "G1", GoalState.WAITING, "for " + number, new GoalEffort(number, 0, 0)));
        }
        journal.afterwards(() -> {});
      }
      assertThat(Files.size(file())).isLessThan(6L << 20);
    }
    assertThat(written(List.of()).goals().get(0).detail()).isEqualTo("for 1999");
  }

  @Test
  void forgetsWhatEndedLongAgoButNotHowFarItHasCounted() {
    List<JournalEntry> entries =
        List.of(
            new JournalEntry.Submitted("G1", request("(in Cup rose)")),
            new JournalEntry.Submitted("G2", request("(in Cup rose)")),
            begun("G2", 1),
            over("G2", GoalState.ACHIEVED));
    assertThat(written(entries).ended()).hasSize(1);
    clock.run(Duration.ofDays(8));

    Recovery recovery = written(List.of());

    assertThat(recovery.ended()).isEmpty();
    assertThat(recovery.goals()).extracting(Recovery.UnfinishedGoal::id).containsExactly("G1");
    assertThat(recovery.lastGoalNumber()).isEqualTo(2);
  }

  @Test
  void translatesTimesToTheClockThatGoesOn() {
    Instant start = Instant.parse("2026-01-01T00:00:00Z");
    Timeline first = new Timeline(start, 10);
    Timeline second = new Timeline(start.plusSeconds(60), 5);

    assertThat(first.translate(Duration.ofSeconds(100), second))
        .as("ten seconds of the wall after the start, fifty before the second clock began")
        .isEqualTo(Duration.ofSeconds(-250));
  }
}
