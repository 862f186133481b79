package org.maestro.bench.losses;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.TreeSet;
import java.util.function.Consumer;
import org.maestro.bench.BenchReport;

/**
 * The recovery after the loss of a container, a host or the platform's process while a goal is
 * pursued: each loss is caused some times, and has to end with the goal reached, no step done twice
 * and no agent there twice. For one thread.
 */
public final class LossesBench {
  private final List<Loss> losses;
  private final int runs;
  private final Consumer<String> progress;

  /**
   * @param losses in the order in which they are to be measured
   * @param runs of each, from 1
   * @param progress told what was measured in each run
   */
  public LossesBench(List<Loss> losses, int runs, Consumer<String> progress) {
    this.losses = List.copyOf(losses);
    this.runs = runs;
    this.progress = progress;
  }

  /**
   * Whether this machine can lose that: a link only where hosts can have addresses of their own.
   */
  public static boolean isPossible(Loss loss) {
    return !loss.isOfLinks() || NetworkHosts.areThere();
  }

  /**
   * @throws IllegalStateException with what happened when a goal was not reached, a step was done
   *     twice, or an agent is there twice
   */
  public BenchReport run() {
    boolean areHosts = NetworkHosts.areThere();
    if (!areHosts) {
      progress.accept(
          "No network namespaces can be made here: hosts are processes on loopback, and no link is"
              + " cut or slowed.");
    }
    List<BenchReport.Row> rows = new ArrayList<>();
    for (Loss loss : losses) {
      if (areHosts || !loss.isOfLinks()) {
        rows.addAll(measured(loss, areHosts));
      }
    }
    return new BenchReport("losses", BenchReport.thisMachine(), rows);
  }

  private List<BenchReport.Row> measured(Loss loss, boolean areHosts) {
    Map<Figure, List<Double>> all = new LinkedHashMap<>();
    for (int run = 1; run <= runs; run++) {
      Map<Figure, Double> figures =
          loss.isOfMain()
              ? new LetterThoughMainLost(loss).run()
              : new CupThoughLoss(loss).run(areHosts);
      figures.forEach(
          (figure, value) -> all.computeIfAbsent(figure, f -> new ArrayList<>()).add(value));
      progress.accept("%s, run %d: %s".formatted(loss.inWords(), run, inWords(figures)));
    }
    List<BenchReport.Row> rows = new ArrayList<>();
    all.forEach(
        (figure, values) -> {
          String name = "%s: %s, ".formatted(loss.inWords(), figure.inWords());
          List<Double> sorted = values.stream().sorted().toList();
          rows.add(BenchReport.Row.of(name + "median", median(sorted), "s"));
          rows.add(BenchReport.Row.of(name + "worst", sorted.get(sorted.size() - 1), "s"));
        });
    return rows;
  }

  private static double median(List<Double> sorted) {
    int middle = sorted.size() / 2;
    return sorted.size() % 2 == 1
        ? sorted.get(middle)
        : (sorted.get(middle - 1) + sorted.get(middle)) / 2;
  }

  private static String inWords(Map<Figure, Double> figures) {
    List<String> parts = new ArrayList<>();
    for (Figure figure : new TreeSet<>(figures.keySet())) {
      parts.add(String.format(Locale.ROOT, "%s %.2f s", figure.inWords(), figures.get(figure)));
    }
    return String.join(", ", parts);
  }

  /** A figure that is measured of a run. */
  enum Figure {
    NOTICED("noticed after"),
    BACK("agent back, from then"),
    ANSWERED("platform answers again after"),
    GOAL("goal reached after, simulated");

    private final String inWords;

    Figure(String inWords) {
      this.inWords = inWords;
    }

    String inWords() {
      return inWords;
    }
  }
}
