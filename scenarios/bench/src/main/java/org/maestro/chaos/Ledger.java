package org.maestro.chaos;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.Recovery;
import org.maestro.faults.FaultyDisk;
import org.maestro.ontology.home.Home;
import org.maestro.platform.journal.JournalFile;
import org.maestro.random.Fault;
import org.maestro.rats.time.Clock;
import org.maestro.rats.time.SteppedClock;

/**
 * The journal of one run on a disk that fails, and what is promised of it: a goal that was taken on
 * is in it, with the end that was told; of what ended no call is left open. For the thread that
 * lets time pass.
 */
final class Ledger implements AutoCloseable {
  private static final int LATEST_MILLIS = 20_000;
  private static final int LONGEST_MILLIS = 15_000;

  /** Some are there before any goal is stated. */
  private static final double AT_ONCE = 0.2;

  private final FaultyDisk disk;
  private final Path directory;
  private final Set<String> accepted = new LinkedHashSet<>();
  private final Map<String, GoalState> told = new TreeMap<>();
  private final List<String> findings = new ArrayList<>();
  private Optional<Begun> begun = Optional.empty();

  /** A journal that is being written, and the home whose words it takes to read it. */
  private record Begun(JournalFile journal, Home home) {}

  Ledger(long seed) {
    this.disk = new FaultyDisk(seed);
    try {
      this.directory = Files.createTempDirectory("maestro-chaos");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** What goes wrong with the disk: mostly nothing. */
  List<Fault> draw(Random random) {
    List<Fault> faults = new ArrayList<>();
    int count = List.of(0, 0, 1, 1, 2).get(random.nextInt(5));
    for (int number = 0; number < count; number++) {
      boolean atOnce = random.nextDouble() < AT_ONCE;
      Duration at = atOnce ? Duration.ZERO : Duration.ofMillis(random.nextInt(LATEST_MILLIS));
      Duration lasts = Duration.ofMillis(random.nextInt(LONGEST_MILLIS));
      int room = random.nextInt(2_000);
      faults.add(
          switch (random.nextInt(5)) {
            case 0 -> fault(at, lasts, "disk full", () -> disk.fillUpTo(room));
            case 1 -> fault(at, lasts, "disk read-only", disk::readOnly);
            case 2 -> fault(at, lasts, "disk gone", disk::takeAway);
            case 3 -> fault(at, lasts, "a write torn", disk::tearNextWrite);
            default -> fault(at, lasts, "nothing made certain", disk::failToForce);
          });
    }
    return faults;
  }

  private Fault fault(Duration at, Duration lasts, String name, Runnable begin) {
    return new Fault.Disturbed(
        at,
        name,
        lasts,
        (bus, clock) -> {
          begin.run();
          clock.schedule(lasts, "disk", disk::heal);
        });
  }

  Journal begin(Home home, Clock clock) {
    JournalFile journal = open(disk.path(directory), clock, home);
    begun = Optional.of(new Begun(journal, home));
    return journal;
  }

  private static JournalFile open(Path path, Clock clock, Home home) {
    return JournalFile.open(path, clock, home.vocabulary()::isFluent);
  }

  void accepted(String goalId) {
    accepted.add(goalId);
  }

  void ended(GoalOutcome outcome) {
    told.put(outcome.id(), outcome.state());
  }

  /** To be asked when the run is over. */
  List<String> findings() {
    begun.ifPresent(this::examine);
    begun = Optional.empty();
    return List.copyOf(findings);
  }

  private void examine(Begun written) {
    disk.heal();
    written.journal().close();
    lookForCalls();
    try (JournalFile again = open(directory, new SteppedClock(), written.home())) {
      compare(again.recovery());
    }
  }

  private void compare(Recovery found) {
    Map<String, GoalState> ended = new TreeMap<>();
    found.ended().forEach(goal -> ended.put(goal.outcome().id(), goal.outcome().state()));
    Set<String> all = new LinkedHashSet<>(ended.keySet());
    found.goals().forEach(goal -> all.add(goal.id()));
    accepted.stream()
        .filter(id -> !all.contains(id))
        .forEach(id -> findings.add("LOST " + id + " was taken on, and is not in the journal"));
    told.forEach(
        (id, state) -> {
          if (ended.get(id) != state) {
            findings.add(
                "OTHER_END %s was told to be %s; the journal says %s"
                    .formatted(id, state, ended.get(id)));
          }
        });
  }

  /** Of goals that are over. */
  private void lookForCalls() {
    Map<String, String> open = new TreeMap<>();
    try (Stream<String> lines = Files.lines(directory.resolve("journal.jsonl"))) {
      lines.forEach(line -> follow(line, open));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    open.forEach(
        (call, goal) -> findings.add("OPEN_CALL " + call + " of " + goal + ", which is over"));
  }

  private void follow(String text, Map<String, String> open) {
    try {
      JsonNode line = new ObjectMapper().readTree(text);
      String goal = line.path("goal").asText();
      String call = line.path("call").asText();
      switch (line.path("event").asText()) {
        case "begun" -> {
          if (told.containsKey(goal)) {
            open.put(call, goal);
          }
        }
        case "ended", "called-off" -> open.remove(call);
        default -> {
          // It is of no call.
        }
      }
    } catch (IOException e) {
      findings.add("UNREADABLE " + e.getMessage());
    }
  }

  @Override
  public void close() {
    try (Stream<Path> files = Files.walk(directory)) {
      for (Path file : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
