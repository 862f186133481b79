package org.maestro.bench.console;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.maestro.assembly.LocalSite;
import org.maestro.bench.BenchReport;
import org.maestro.bench.MemorySample;
import org.maestro.bench.SoakGoals;

/** A page that stays open while goals come and go: what page and server hold by and by. */
final class OpenPage {
  private static final int GOALS_BETWEEN_LOOKS = 10;

  /** What is made once, such as compiled code and caches, is there by then. */
  private static final double WARM_SHARE = 0.25;

  /** Somebody looks after its battery, which is empty after some thousand goals. */
  private static final String ROBOT = "rose";

  private record Held(double minutes, double pageMiB, int elements, double serverMiB) {}

  private final LocalSite site;
  private final SeenPage page;
  private final Consumer<String> progress;

  OpenPage(LocalSite site, SeenPage page, Consumer<String> progress) {
    this.site = site;
    this.page = page;
    this.progress = progress;
  }

  List<BenchReport.Row> rows(Duration open) {
    SoakGoals goals = new SoakGoals(site.platform(), progress);
    List<Held> held = new ArrayList<>();
    long begin = System.nanoTime();
    int goal = 0;
    while (minutesSince(begin) < open.toMillis() / 60_000.0) {
      goals.pursue(++goal);
      if (goal % GOALS_BETWEEN_LOOKS == 0) {
        site.world().charge(ROBOT, 1);
        held.add(look(begin, goal));
      }
    }
    List<Held> warm =
        held.stream().filter(one -> one.minutes() >= WARM_SHARE * minutesSince(begin)).toList();
    if (warm.size() < 2) {
      return List.of(BenchReport.Row.of("open, goals", goal, "goals"));
    }
    Held first = warm.get(0);
    Held last = warm.get(warm.size() - 1);
    return List.of(
        BenchReport.Row.of("open, goals", goal, "goals"),
        BenchReport.Row.of("open, from minute", first.minutes(), "min"),
        BenchReport.Row.of("open, to minute", last.minutes(), "min"),
        BenchReport.Row.of("open, page at first", first.pageMiB(), "MiB"),
        BenchReport.Row.of("open, page at last", last.pageMiB(), "MiB"),
        BenchReport.Row.of("open, elements at first", first.elements(), "elements"),
        BenchReport.Row.of("open, elements at last", last.elements(), "elements"),
        BenchReport.Row.of("open, server at first", first.serverMiB(), "MiB"),
        BenchReport.Row.of("open, server at last", last.serverMiB(), "MiB"));
  }

  private Held look(long begin, int goal) {
    Held now =
        new Held(
            minutesSince(begin),
            page.heapMiB(),
            page.elements(),
            MemorySample.take(goal).heapMiB());
    progress.accept(
        String.format(
            Locale.ROOT,
            "%6.1f min, %4d goals: page %.2f MiB in %d elements, server %.2f MiB live",
            now.minutes(),
            goal,
            now.pageMiB(),
            now.elements(),
            now.serverMiB()));
    return now;
  }

  private static double minutesSince(long begin) {
    return (System.nanoTime() - begin) / 60e9;
  }
}
