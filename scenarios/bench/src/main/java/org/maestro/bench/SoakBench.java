package org.maestro.bench;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.ToDoubleFunction;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.ontology.home.Home;
import org.maestro.sim.scene.Scene;

/**
 * Goals one after the other, for a long time, on one platform in this process with all that it
 * keeps on disk: how much memory each of them leaves behind. For one thread.
 */
public final class SoakBench {
  private static final double SPEED = 50;
  private static final int GOALS_BETWEEN_SAMPLES = 25;

  /** As a share of all: what is made once, such as caches and compiled code, is there by then. */
  private static final double BEFORE_THE_SLOPE = 0.5;

  private final Home home;
  private final Scene scene;
  private final int goals;
  private final Consumer<String> progress;

  /**
   * @param home Bob's: the goals are about it
   * @param goals at least 250
   * @param progress told what is being done
   */
  public SoakBench(Home home, Scene scene, int goals, Consumer<String> progress) {
    this.home = home;
    this.scene = scene;
    this.goals = goals;
    this.progress = progress;
  }

  public BenchReport run() {
    try (TemporaryDirectory directory = TemporaryDirectory.make()) {
      return run(directory.path());
    }
  }

  private BenchReport run(Path directory) {
    SiteSettings settings =
        SiteSettings.of("bench-soak", home)
            .scene(scene)
            .storyDirectory(directory.resolve("stories"))
            .dataDirectory(directory)
            .build();
    List<MemorySample> samples = new ArrayList<>();
    Map<SoakGoals.End, Integer> ends = new EnumMap<>(SoakGoals.End.class);
    try (LocalSite site = LocalSite.paced(settings, SPEED)) {
      SoakGoals each = new SoakGoals(site.platform(), progress);
      for (int goal = 1; goal <= goals; goal++) {
        ends.merge(each.pursue(goal), 1, Integer::sum);
        if (goal % GOALS_BETWEEN_SAMPLES == 0) {
          MemorySample sample = MemorySample.take(goal);
          progress.accept(sample.line());
          samples.add(sample);
        }
      }
    }
    return new BenchReport("soak", BenchReport.thisMachine(), rows(samples, ends));
  }

  private List<BenchReport.Row> rows(List<MemorySample> samples, Map<SoakGoals.End, Integer> ends) {
    List<BenchReport.Row> rows = new ArrayList<>();
    ends.forEach(
        (end, count) -> rows.add(BenchReport.Row.of("goals " + end.words(), count, "goals")));
    List<MemorySample> settled =
        samples.stream().filter(sample -> sample.goals() >= BEFORE_THE_SLOPE * goals).toList();
    MemorySample first = settled.get(0);
    MemorySample last = settled.get(settled.size() - 1);
    String since = " after goal " + first.goals();
    rows.add(BenchReport.Row.of("live heap" + since, first.heapMiB(), "MiB"));
    rows.add(BenchReport.Row.of("live heap after goal " + last.goals(), last.heapMiB(), "MiB"));
    rows.add(growth("the live heap", settled, MemorySample::heapMiB));
    rows.add(BenchReport.Row.of("resident" + since, first.residentMiB(), "MiB"));
    rows.add(BenchReport.Row.of("resident after goal " + last.goals(), last.residentMiB(), "MiB"));
    rows.add(growth("what is resident", settled, MemorySample::residentMiB));
    rows.add(growth("the heap, live or free", settled, MemorySample::committedMiB));
    rows.add(growth("classes and compiled code", settled, MemorySample::programMiB));
    rows.add(growth("the rest of what is resident", settled, MemorySample::restMiB));
    return rows;
  }

  private static BenchReport.Row growth(
      String what, List<MemorySample> samples, ToDoubleFunction<MemorySample> figure) {
    return BenchReport.Row.of(
        "growth of " + what + " for 100 goals", MemorySample.slope(samples, figure), "MiB");
  }
}
