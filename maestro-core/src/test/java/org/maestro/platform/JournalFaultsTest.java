package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.coordination.api.GoalEffort;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.faults.FaultyDisk;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.platform.journal.JournalFile;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/**
 * A journal on a disk that fails: no goal that was accepted is lost, none that was refused runs.
 */
class JournalFaultsTest {
  private static final int STEPS = 40;
  private static final Duration NEXT_TRY = Duration.ofSeconds(2);

  @TempDir private Path directory;

  private static JournalEntry.Submitted goal(String id) {
    return goal(id, "Bob");
  }

  private static JournalEntry.Submitted goal(String id, String requester) {
    return new JournalEntry.Submitted(
        id, new GoalRequest(SlParser.formula("(in Cup rose)", "level"::equals), requester));
  }

  private static JournalEntry.Became waits(String id, String reason) {
    return new JournalEntry.Became(id, GoalState.WAITING, reason, new GoalEffort(1, 0, 0));
  }

  private static Set<String> goals(Recovery recovery) {
    return recovery.goals().stream()
        .map(Recovery.UnfinishedGoal::id)
        .collect(Collectors.toCollection(LinkedHashSet::new));
  }

  /** A platform's journal, its disk, and what it has promised. */
  private static final class Life {
    private final Set<String> accepted = new LinkedHashSet<>();
    private final List<String> refusals = new ArrayList<>();
    private final Random chance;
    private final Path data;
    private SteppedClock clock;
    private FaultyDisk disk;
    private JournalFile journal;
    private int stated;

    private Life(long seed, Path data) {
      this.chance = new Random(seed);
      this.data = data;
    }

    private void begin() {
      clock = new SteppedClock();
      disk = new FaultyDisk(chance.nextLong());
      journal = JournalFile.open(disk.path(data), clock, "level"::equals);
      assertThat(goals(journal.recovery())).isEqualTo(accepted);
    }

    private void step() throws IOException {
      switch (chance.nextInt(12)) {
        case 0 -> disk.fillUpTo(chance.nextInt(3_000));
        case 1 -> disk.readOnly();
        case 2 -> disk.takeAway();
        case 3 -> disk.tearNextWrite();
        case 4 -> disk.failToForce();
        case 5 -> disk.heal();
        case 6 -> clock.run(NEXT_TRY);
        case 7 -> accepted.stream().findAny().ifPresent(id -> journal.write(waits(id, "for news")));
        case 8 -> {
          disk.die(chance.nextBoolean());
          begin();
        }
        default -> state();
      }
    }

    private void state() {
      String id = "G" + ++stated;
      int before = refusals.size();
      journal.accept(goal(id), () -> accepted.add(id), refusals::add);
      assertThat(accepted.contains(id)).as(id).isNotEqualTo(refusals.size() > before);
      assertThat(journal.impediment().isPresent())
          .as("who asks is told why goals are refused")
          .isEqualTo(refusals.size() > before);
    }

    private void healed() throws IOException {
      disk.heal();
      clock.run(NEXT_TRY);
      int before = refusals.size();
      state();
      assertThat(refusals).as("once the disk is well").hasSize(before);
      disk.die(true);
      begin();
      journal.close();
    }
  }

  @Test
  void whateverTheDiskDoesAcceptedGoalsStayAndRefusedOnesDoNot() {
    liveWith(0, 40);
  }

  @Test
  @Tag("full")
  void whateverTheDiskDoesWithManySeeds() {
    liveWith(40, 1_000);
  }

  private void liveWith(long from, long to) {
    int refused = 0;
    for (long seed = from; seed < to; seed++) {
      Life life = new Life(seed, directory.resolve("seed-" + seed));
      try {
        life.begin();
        for (int step = 0; step < STEPS; step++) {
          life.step();
        }
        life.healed();
      } catch (AssertionError | RuntimeException | IOException e) {
        throw new AssertionError("With the seed " + seed + ": " + e.getMessage(), e);
      }
      refused += life.refusals.size();
      assertThat(life.refusals)
          .allMatch(
              sentence ->
                  sentence.startsWith("The goal is not taken on, because the journal in ")
                      && sentence.endsWith("See to it, and state the goal again."));
    }
    assertThat(refused).as("the faults act").isGreaterThan((int) (to - from));
  }

  @Test
  void aFullDiskIsNamedAndHasWhatRunsWait() {
    SteppedClock clock = new SteppedClock();
    FaultyDisk disk = new FaultyDisk(1);
    List<String> heard = new ArrayList<>();
    try (JournalFile journal = JournalFile.open(disk.path(directory), clock, "level"::equals)) {
      journal.accept(goal("G1"), () -> heard.add("accepted"), heard::add);
      disk.fillUpTo(100);
      journal.write(waits("G1", "for the disk"));
      journal.afterwards(() -> heard.add("written"));
      journal.accept(goal("G2"), () -> heard.add("accepted"), heard::add);
      assertThat(heard).hasSize(2).first().isEqualTo("accepted");
      assertThat(heard.get(1)).contains(directory.toString(), "No space left on device");

      disk.heal();
      clock.run(NEXT_TRY);
      assertThat(heard).hasSize(3).last().isEqualTo("written");
      journal.accept(goal("G3"), () -> heard.add("accepted again"), heard::add);
      assertThat(heard).last().isEqualTo("accepted again");
    }
    try (JournalFile journal = JournalFile.open(directory, clock, "level"::equals)) {
      assertThat(goals(journal.recovery())).containsExactly("G1", "G3");
      assertThat(journal.recovery().goals().get(0).detail()).isEqualTo("for the disk");
    }
  }

  @Test
  void aSlowDiskHoldsNobodyUpAndAGoalThatIsWrittenTooLateIsWithdrawn() throws Exception {
    FaultyDisk disk = new FaultyDisk(1);
    BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    try (PacedClock clock = new PacedClock(1)) {
      try (JournalFile journal =
          JournalFile.open(disk.path(directory), clock, "level"::equals, Duration.ofMillis(200))) {
        journal.accept(goal("G1"), () -> heard.add("accepted"), heard::add);
        assertThat(heard.poll(20, TimeUnit.SECONDS)).isEqualTo("accepted");
        disk.slow();
        journal.accept(goal("G2"), () -> heard.add("accepted"), heard::add);
        journal.accept(goal("G3"), () -> heard.add("accepted"), heard::add);
        assertThat(heard.poll(20, TimeUnit.SECONDS)).contains("has not taken it within 0.2 s");
        assertThat(heard.poll(20, TimeUnit.SECONDS)).contains("has not taken it within 0.2 s");
        assertThat(Awaitility.await().until(journal::impediment, Optional::isPresent).orElseThrow())
            .contains(directory.toString(), "has not taken it within 0.2 s");
        disk.heal();
        journal.afterwards(() -> heard.add("written"));
        assertThat(heard.poll(20, TimeUnit.SECONDS)).isEqualTo("written");
        Awaitility.await().until(() -> journal.impediment().isEmpty());
      }
      try (JournalFile journal = JournalFile.open(directory, clock, "level"::equals)) {
        assertThat(goals(journal.recovery())).containsExactly("G1");
        assertThat(journal.recovery().lastGoalNumber()).isEqualTo(3);
      }
    }
  }

  @Test
  void aDirectoryThatIsMadeAgainHasAllOfIt() throws IOException {
    SteppedClock clock = new SteppedClock();
    Path data = directory.resolve("data");
    List<String> heard = new ArrayList<>();
    try (JournalFile journal = JournalFile.open(data, clock, "level"::equals)) {
      journal.accept(goal("G1"), () -> heard.add("accepted"), heard::add);
      for (String name : List.of("journal.jsonl", "journal.mark", "lock")) {
        Files.delete(data.resolve(name));
      }
      Files.delete(data);
      journal.accept(goal("G2"), () -> heard.add("accepted"), heard::add);
      assertThat(heard.get(1)).contains("there is no " + data.resolve("journal.jsonl"));
      Files.createDirectory(data);
      clock.run(NEXT_TRY);
      journal.accept(goal("G3"), () -> heard.add("accepted again"), heard::add);
      assertThat(heard).last().isEqualTo("accepted again");
      assertThatThrownBy(() -> JournalFile.open(data, clock, "level"::equals))
          .as("it is its own again")
          .hasMessageContaining("in use");
    }
    try (JournalFile journal = JournalFile.open(data, clock, "level"::equals)) {
      assertThat(goals(journal.recovery())).containsExactly("G1", "G3");
    }
  }

  /** Five goals and what became of them. */
  private List<String> written() throws IOException {
    return written("Bob");
  }

  private List<String> written(String requester) throws IOException {
    SteppedClock clock = new SteppedClock();
    try (JournalFile journal = JournalFile.open(directory, clock, "level"::equals)) {
      for (int number = 1; number <= 5; number++) {
        journal.accept(goal("G" + number, requester), () -> {}, refusal -> {});
        journal.write(waits("G" + number, "for the others"));
      }
      journal.afterwards(() -> {});
    }
    return Files.readAllLines(directory.resolve("journal.jsonl"));
  }

  private Optional<String> complaint(FaultyDisk disk) {
    try (JournalFile journal =
        JournalFile.open(disk.path(directory), new SteppedClock(), "level"::equals)) {
      assertThat(goals(journal.recovery())).containsExactly("G1", "G2", "G3", "G4", "G5");
      return Optional.empty();
    } catch (PlatformStartException e) {
      return Optional.of(e.getMessage());
    }
  }

  @Test
  void aJournalThatIsCutAtTheEndOfALineSaysWhichLinesAreMissing() throws IOException {
    List<String> lines = written();
    for (int left = 0; left < lines.size(); left++) {
      Files.write(directory.resolve("journal.jsonl"), lines.subList(0, left));
      String missing =
          left + 1 == lines.size()
              ? "line %d is missing at its end".formatted(lines.size())
              : "the lines %d to %d are missing at its end".formatted(left + 1, lines.size());
      assertThat(complaint(new FaultyDisk(1)))
          .hasValueSatisfying(
              sentence ->
                  assertThat(sentence)
                      .contains(directory.resolve("journal.jsonl").toString(), missing)
                      .contains("delete " + directory.resolve("journal.mark")));
    }
    Files.write(directory.resolve("journal.jsonl"), lines.subList(0, 4));
    Files.delete(directory.resolve("journal.mark"));
    try (JournalFile journal = JournalFile.open(directory, new SteppedClock(), "level"::equals)) {
      assertThat(goals(journal.recovery())).as("as somebody wanted it").containsExactly("G1", "G2");
    }
  }

  @Test
  void aJournalWithoutItsMiddleSaysWhichLinesAreMissingAndOfWhichGoals() throws IOException {
    List<String> lines = written();
    for (int from = 1; from < lines.size() - 1; from++) {
      for (int to = from + 1; to < lines.size(); to++) {
        List<String> left = new ArrayList<>(lines.subList(0, from));
        left.addAll(lines.subList(to, lines.size()));
        Files.write(directory.resolve("journal.jsonl"), left);
        String missing =
            to == from + 1
                ? "line %d is missing".formatted(to)
                : "the lines %d to %d are missing".formatted(from + 1, to);
        assertThat(complaint(new FaultyDisk(1)))
            .hasValueSatisfying(sentence -> assertThat(sentence).contains(missing));
      }
    }
    List<String> withoutBeginnings = new ArrayList<>(lines);
    withoutBeginnings.remove(3);
    Files.write(directory.resolve("journal.jsonl"), withoutBeginnings);
    assertThat(complaint(new FaultyDisk(1)).orElseThrow())
        .contains("damaged in line 4", "what these goals were is not said any more: G2;");
  }

  @Test
  void aLineOfAnotherJournalIsNoticed() throws IOException {
    List<String> lines = written();
    Files.delete(directory.resolve("journal.jsonl"));
    Files.delete(directory.resolve("journal.mark"));
    List<String> others = new ArrayList<>(written("Anna"));
    assertThat(others.get(5)).isNotEqualTo(lines.get(5));
    others.set(5, lines.get(5));
    Files.write(directory.resolve("journal.jsonl"), others);

    assertThat(complaint(new FaultyDisk(1)).orElseThrow())
        .contains("it was written after another line than the one before it");
  }

  @Test
  void aChangedBitIsNoticedWhereverItIs() throws IOException {
    written();
    long bits = Files.size(directory.resolve("journal.jsonl")) * Byte.SIZE;
    Random chance = new Random(1);
    for (int round = 0; round < 60; round++) {
      long bit = round < 8 ? bits - 1 - round : (long) (chance.nextDouble() * bits);
      FaultyDisk disk = new FaultyDisk(1);
      disk.flip(bit);
      assertThat(complaint(disk))
          .as("bit " + bit)
          .hasValueSatisfying(
              sentence -> assertThat(sentence).contains("The journal " + directory));
    }
    assertThat(complaint(new FaultyDisk(1))).as("nobody has written meanwhile").isEmpty();
  }

  @ParameterizedTest
  @ValueSource(booleans = {true, false})
  void aJournalOfTheVersionBeforeIsRead(boolean torn) throws IOException {
    String old =
        """
        {"n":1,"event":"journal","format":1,"since":"2026-01-01T00:00:00Z","speed":1.0,"last_goal":0,"crc":"846427d0"}
        {"n":2,"at_s":0.000,"event":"submitted","goal":"G1","asks":"(in Cup rose)","requester":"Bob","priority":0,"crc":"2a9c2b3a"}
        """;
    Files.writeString(
        directory.resolve("journal.jsonl"), torn ? old + "{\"n\":3,\"at_s\":0.0" : old);
    try (JournalFile journal = JournalFile.open(directory, new SteppedClock(), "level"::equals)) {
      assertThat(goals(journal.recovery())).containsExactly("G1");
    }
    assertThat(Files.readAllLines(directory.resolve("journal.jsonl")))
        .hasSize(2)
        .allMatch(line -> line.contains("\"after\":"));
  }
}
