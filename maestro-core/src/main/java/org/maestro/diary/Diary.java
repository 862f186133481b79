package org.maestro.diary;

import java.nio.file.Path;
import java.time.Instant;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Home;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Fact;
import org.maestro.sl.SlPrinter;
import org.maestro.storage.WritingAside;

/**
 * The diary of a home: what became so and what was asked for, by the date that its clocks show. The
 * latest is in memory, and where there is a directory each day has a file. Any thread may use it.
 */
public final class Diary implements AutoCloseable {
  private static final int MOST_IN_MEMORY = 20_000;

  private final Supplier<Home> home;
  private final Clock clock;
  private final Optional<DiaryFiles> files;
  private final WritingAside aside;

  /** Guarded by this. */
  private final List<DiaryLine> latest = new ArrayList<>();

  /** The last fact of each state variable; guarded by this. */
  private final Map<String, String> lastFacts = new LinkedHashMap<>();

  /** Of the home as it was when something was noted last; guarded by this. */
  private Optional<Noteworthy> noteworthy = Optional.empty();

  /** The date of the last line; guarded by this. */
  private Optional<LocalDate> today = Optional.empty();

  /**
   * @param home as it is known at the time
   * @param clock the home's
   * @param directory of files; empty: it ends with the process
   */
  public Diary(Supplier<Home> home, Clock clock, Optional<Path> directory) {
    this.home = home;
    this.clock = clock;
    this.files = directory.map(DiaryFiles::new);
    String subject = "Lines of the diary";
    this.aside =
        clock.isStepped() || directory.isEmpty()
            ? WritingAside.atOnce(subject)
            : WritingAside.begin(subject);
  }

  /** From now on it is told; what was so before may have ended unseen. */
  public void begin() {
    add(new DiaryLine.Begun(clock.instant()));
  }

  /** Something has become known, or is not known any more; what a step is for counts once it is. */
  public void note(KnowledgeBase.Change change) {
    Instant now = clock.instant();
    Noteworthy words = words();
    for (String text : change.reported()) {
      Noteworthy.read(text).filter(words::is).ifPresent(fact -> add(now, fact, text, words));
    }
  }

  private synchronized Noteworthy words() {
    Home present = home.get();
    if (noteworthy.filter(words -> words.isOf(present)).isEmpty()) {
      noteworthy = Optional.of(new Noteworthy(present));
    }
    return noteworthy.orElseThrow();
  }

  private synchronized void add(Instant now, Fact fact, String text, Noteworthy words) {
    carryOver(now);
    String subject = words.subject(fact);
    Optional<String> last = Optional.ofNullable(lastFacts.get(subject));
    boolean isElsewhere =
        words.whereabouts(fact).isPresent() && !(fact instanceof Fact.Holds) && !isEnd(last, fact);
    if (!isElsewhere && !last.equals(Optional.of(text))) {
      lastFacts.put(subject, text);
      put(new DiaryLine.Became(now, text));
    }
  }

  /** That somebody is not in a zone is news only where she was known to be. */
  private static boolean isEnd(Optional<String> last, Fact fact) {
    return last.equals(Noteworthy.atom(fact).map(atom -> SlPrinter.print(new Fact.Holds(atom))));
  }

  /** Somebody has asked for something, or that has come to its end. */
  public void note(JournalEntry entry) {
    Instant now = clock.instant();
    if (entry instanceof JournalEntry.Submitted submitted && isWhole(submitted.goalId())) {
      add(
          new DiaryLine.Asked(
              now,
              submitted.goalId(),
              SlPrinter.print(submitted.request().goal()),
              submitted.request().requester()));
    } else if (entry instanceof JournalEntry.Over over) {
      GoalState state = over.outcome().state();
      String end =
          state == GoalState.ACHIEVED
              ? over.outcome().confirmed() ? "reached" : "unseen"
              : state == GoalState.CANCELLED ? "cancelled" : "failed";
      add(
          new DiaryLine.Over(
              now,
              over.goalId(),
              end,
              state == GoalState.ACHIEVED ? "" : String.join(" ", over.outcome().reasons())));
    }
  }

  /** The steps of a script are no wishes of anybody. */
  private static boolean isWhole(String goalId) {
    return !GoalId.isPart(goalId);
  }

  private synchronized void add(DiaryLine line) {
    carryOver(line.at());
    put(line);
  }

  /** A new day begins with what was so at the end of the one before. */
  private void carryOver(Instant now) {
    LocalDate day = day(now);
    if (today.filter(day::isAfter).isPresent()) {
      Instant midnight = day.atStartOfDay(zone()).toInstant();
      List.copyOf(lastFacts.values()).forEach(fact -> put(new DiaryLine.Became(midnight, fact)));
    }
    today = Optional.of(day);
  }

  private void put(DiaryLine line) {
    latest.add(line);
    if (latest.size() > MOST_IN_MEMORY) {
      latest.remove(0);
    }
    files.ifPresent(
        all -> {
          String text = LineCodec.write(line);
          LocalDate day = day(line.at());
          aside.add(text.length(), () -> all.write(day, text));
        });
  }

  private LocalDate day(Instant at) {
    return at.atZone(zone()).toLocalDate();
  }

  /** Of the clocks on the home's walls. */
  public ZoneId zone() {
    return home.get().timeZone().orElseGet(ZoneId::systemDefault);
  }

  /** The date that they show. */
  public LocalDate today() {
    return day(clock.instant());
  }

  /**
   * A person's day; empty when nothing is kept of it.
   *
   * @param person by her name in the home
   * @param hidden words of which nothing is told who asks
   */
  public Optional<DayReport> report(String person, LocalDate day, Set<String> hidden) {
    List<DiaryLine> lines = files.map(all -> all.read(day)).orElseGet(() -> inMemory(day));
    if (lines.isEmpty()) {
      return Optional.empty();
    }
    Instant from = day.atStartOfDay(zone()).toInstant();
    Instant to = day.plusDays(1).atStartOfDay(zone()).toInstant();
    Instant now = clock.instant();
    return Optional.of(
        new DayReading(words(), home.get(), person, hidden)
            .read(day, lines, from, now.isBefore(to) ? now : to));
  }

  private synchronized List<DiaryLine> inMemory(LocalDate day) {
    return latest.stream().filter(line -> day(line.at()).equals(day)).toList();
  }

  /** What was told is written, or left away when the disk does not take it in time. */
  @Override
  public void close() {
    aside.close();
  }
}
