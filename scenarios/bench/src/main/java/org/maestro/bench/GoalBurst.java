package org.maestro.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntFunction;
import java.util.function.Predicate;
import org.maestro.agents.DeskAgent;
import org.maestro.assembly.LocalSite;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.platform.JoinedContainer;
import org.maestro.sl.SlParser;

/**
 * Many goals stated within a second by two who ask for them, one for most and one for few. What
 * counts for them is when their goals end, in the mean and at last, and that who asks for few does
 * not wait for all that the other asks for; measured too is when each goal was awarded (its plan is
 * found and its agents have it) or queued. For one thread.
 */
final class GoalBurst {
  /** Then the story names what the goal waits for, and who has it. */
  private static final String QUEUED = "Waits: ";

  private static final double AWARD_LIMIT_SECONDS = 5;
  private static final long PATIENCE_SECONDS = 180;

  /** One goal of so many is the second one's. */
  private static final int FEW = 11;

  private final LocalSite site;
  private final int goals;
  private final IntFunction<String> goal;
  private final Map<String, Long> awardedNanos = new ConcurrentHashMap<>();
  private final Map<Integer, Long> endedNanos = new ConcurrentHashMap<>();
  private final Map<Integer, Boolean> reached = new ConcurrentHashMap<>();
  private final Map<Integer, String> accepted = new ConcurrentHashMap<>();

  /**
   * @param goal by its number, from 0
   */
  GoalBurst(LocalSite site, int goals, IntFunction<String> goal) {
    this.site = site;
    this.goals = goals;
    this.goal = goal;
  }

  List<BenchReport.Row> measure() {
    site.platform()
        .onStory(
            entry -> {
              if (entry.kind() == StoryEntry.Kind.PLAN
                  || entry.kind() == StoryEntry.Kind.END
                  || entry.text().startsWith(QUEUED)) {
                awardedNanos.putIfAbsent(entry.goalId(), System.nanoTime());
              }
            });
    try (JoinedContainer second =
        JoinedContainer.join(
            Optional.of(site.platform().desk().getHap()),
            "127.0.0.1",
            site.platform().port(),
            "second",
            site.clock())) {
      long begin = System.nanoTime();
      for (int i = 0; i < goals; i++) {
        pause(begin + i * 1_000_000_000L / goals);
        state(i, isOfFew(i) ? second.desk() : site.platform().desk());
      }
      long limit = begin + PATIENCE_SECONDS * 1_000_000_000L;
      while (endedNanos.size() < goals && System.nanoTime() < limit) {
        LockSupport.parkNanos(5_000_000);
      }
      return rows(begin);
    }
  }

  private void state(int number, DeskAgent desk) {
    desk.pursue(
        SlParser.formula(
            goal.apply(number), site.platform().knowledge().home().vocabulary()::isFluent),
        id -> accepted.put(number, id),
        report -> {
          reached.put(number, report.reached());
          endedNanos.put(number, System.nanoTime());
        });
  }

  private static boolean isOfFew(int number) {
    return number % FEW == FEW - 1;
  }

  private List<BenchReport.Row> rows(long begin) {
    List<BenchReport.Row> rows = new ArrayList<>();
    List<Double> awarded = seconds(awardedNanos.values(), begin);
    rows.add(
        BenchReport.Row.of(
            "burst: goals awarded or queued within 5 s",
            (double) awarded.stream().filter(s -> s <= AWARD_LIMIT_SECONDS).count(),
            "goals"));
    rows.add(BenchReport.Row.of("burst: goals stated", accepted.size(), "goals"));
    last(awarded)
        .ifPresent(
            seconds ->
                rows.add(
                    BenchReport.Row.of(
                        "burst: last of %d awarded or queued after".formatted(awarded.size()),
                        seconds,
                        "s")));
    rows.add(
        BenchReport.Row.of(
            "burst: goals reached",
            (double) reached.values().stream().filter(Boolean::booleanValue).count(),
            "goals"));
    rows.add(BenchReport.Row.of("burst: goals ended", endedNanos.size(), "goals"));
    addMean("burst: mean time to the end", number -> true, begin, rows);
    addMean("burst: the same of who states many", number -> !isOfFew(number), begin, rows);
    addMean("burst: the same of who states few", GoalBurst::isOfFew, begin, rows);
    last(seconds(endedNanos.values(), begin))
        .ifPresent(seconds -> rows.add(BenchReport.Row.of("burst: last end after", seconds, "s")));
    return rows;
  }

  private void addMean(
      String name, Predicate<Integer> ofThese, long begin, List<BenchReport.Row> rows) {
    Map<Integer, Long> ended = new HashMap<>(endedNanos);
    ended.keySet().removeIf(ofThese.negate());
    seconds(ended.values(), begin).stream()
        .mapToDouble(Double::doubleValue)
        .average()
        .ifPresent(seconds -> rows.add(BenchReport.Row.of(name, seconds, "s")));
  }

  private static List<Double> seconds(Iterable<Long> nanos, long begin) {
    List<Double> seconds = new ArrayList<>();
    nanos.forEach(at -> seconds.add((at - begin) / 1e9));
    return seconds;
  }

  private static OptionalDouble last(List<Double> seconds) {
    return seconds.stream().mapToDouble(Double::doubleValue).max();
  }

  private static void pause(long untilNanos) {
    while (System.nanoTime() < untilNanos) {
      LockSupport.parkNanos(500_000);
    }
  }
}
