package org.maestro.experiment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.maestro.experiment.ExplorationRun.Condition;
import org.maestro.experiment.measuring.Interval;
import org.maestro.experiment.measuring.Share;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.setting.Setting;

/**
 * A robot on another planet is directed by words to a place from which it can transmit; in one
 * condition its voice is stressed once its battery is low (ADE, 4). The subjects are simulated, and
 * what a stressed voice does to them is assumed: the same subjects under each assumption.
 */
final class Exploration implements Experiment {
  static final String NAME = "exploration";

  private static final Setting AFFECT =
      Setting.choice(
          "affect",
          "both",
          List.of("on", "off", "both"),
          "whether the robot's voice is stressed after its first report, neutral, or each in turn");

  /** Assumptions about how much shorter a subject thinks that hears a stressed voice. */
  private static final List<Double> KAPPAS = List.of(0.0, 0.1, 0.2, 0.3);

  private static final Condition CONTROL = new Condition(false, 0);

  /** All runs under one condition. */
  record Series(Condition condition, List<ExplorationRun> runs) {

    Share successes() {
      return new Share((int) runs.stream().filter(ExplorationRun::success).count(), runs.size());
    }

    /** Of all runs: those without success have the whole time of the mission. */
    Spread times() {
      return Spread.of(runs.stream().mapToDouble(ExplorationRun::seconds).toArray());
    }

    /** Of those with success. */
    Spread timesOfSuccesses() {
      return Spread.of(
          runs.stream()
              .filter(ExplorationRun::success)
              .mapToDouble(ExplorationRun::seconds)
              .toArray());
    }

    /** How much longer the same subjects took than under another condition. */
    Spread longerThan(Series other) {
      return Spread.of(
          DoubleStream.iterate(0, i -> i < runs.size(), i -> i + 1)
              .map(i -> runs.get((int) i).seconds() - other.runs().get((int) i).seconds())
              .toArray());
    }

    /** Whether neither success nor time differs by more than the intervals in which both lie. */
    boolean agreesWith(Series other) {
      Share one = successes();
      Share two = other.successes();
      return new Interval(one.least(), one.greatest())
              .overlaps(new Interval(two.least(), two.greatest()))
          && Interval.ofMean(times()).overlaps(Interval.ofMean(other.times()));
    }
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public String purpose() {
    return "a robot is directed by words to where it can transmit; affect in its voice (ADE, section 4)";
  }

  @Override
  public int usualRuns() {
    return 20;
  }

  @Override
  public List<Setting> settings() {
    return Stream.concat(Stream.of(AFFECT), ExplorationRun.settings().stream()).toList();
  }

  @Override
  public Course<?> begin(Request request) {
    List<Condition> conditions = conditions(request.settings().value(AFFECT));
    return new Course<>(
        request.runs(),
        run -> inEach(conditions, request, run),
        Exploration::inWords,
        all -> findings(request, series(conditions, all)));
  }

  private static List<Condition> conditions(String affect) {
    List<Condition> conditions = new ArrayList<>();
    if (!affect.equals("on")) {
      conditions.add(CONTROL);
    }
    if (!affect.equals("off")) {
      KAPPAS.forEach(kappa -> conditions.add(new Condition(true, kappa)));
    }
    return List.copyOf(conditions);
  }

  /** The same subject at the same place under each condition. */
  private static List<ExplorationRun> inEach(List<Condition> conditions, Request request, int run) {
    return conditions.stream()
        .map(
            condition ->
                ExplorationRun.carryOut(
                    run,
                    request.seedOf(run),
                    condition,
                    request.settings(),
                    run == 1 && condition.equals(conditions.get(0))))
        .toList();
  }

  private static String inWords(List<ExplorationRun> runs) {
    return String.join(
        ", ",
        runs.stream()
            .map(
                run ->
                    "%s %s"
                        .formatted(
                            run.condition().label(),
                            run.success() ? Math.round(run.seconds()) + " s" : "time over"))
            .toList());
  }

  private static List<Series> series(List<Condition> conditions, List<List<ExplorationRun>> all) {
    List<Series> series = new ArrayList<>();
    for (int i = 0; i < conditions.size(); i++) {
      int number = i;
      series.add(
          new Series(conditions.get(i), all.stream().map(runs -> runs.get(number)).toList()));
    }
    return List.copyOf(series);
  }

  private static Findings findings(Request request, List<Series> all) {
    Map<String, Table> tables = new LinkedHashMap<>();
    tables.put("runs", runs(all));
    tables.put("readings", readings(all));
    tables.put("words", words(all));
    ExplorationFigures figures = new ExplorationFigures(all);
    return new Findings(
        NAME,
        results(all),
        tables,
        figures.drawn(),
        ExplorationPage.of(request, all, figures.drawn()));
  }

  private static List<Findings.Result> results(List<Series> all) {
    List<Findings.Result> results = new ArrayList<>();
    for (Series series : all) {
      String label = series.condition().label();
      results.add(new Findings.Result(label + ": runs", series.runs().size(), ""));
      results.add(new Findings.Result(label + ": sent", series.successes().hits(), "runs"));
      results.add(new Findings.Result(label + ": time, mean", series.times().mean(), "s"));
    }
    return results;
  }

  private static Table runs(List<Series> all) {
    Table table =
        new Table(
            "run",
            "seed",
            "goal",
            "success",
            "duration_s",
            "lower_bound_s",
            "replans",
            "failure",
            "condition",
            "kappa",
            "utterances",
            "readings",
            "strongest_reading");
    for (Series series : all) {
      for (ExplorationRun run : series.runs()) {
        table.add(
            run.number(),
            run.seed(),
            "transmit",
            run.success(),
            run.seconds(),
            run.boundSeconds(),
            0,
            run.failure(),
            run.condition().key(),
            run.condition().kappa(),
            run.utterances(),
            run.readings().size(),
            run.readings().stream().mapToInt(Integer::intValue).max().orElse(0));
      }
    }
    return table;
  }

  private static Table readings(List<Series> all) {
    Table table = new Table("run", "condition", "kappa", "number", "signal");
    for (Series series : all) {
      for (ExplorationRun run : series.runs()) {
        for (int i = 0; i < run.readings().size(); i++) {
          table.add(
              run.number(),
              run.condition().key(),
              run.condition().kappa(),
              i + 1,
              run.readings().get(i));
        }
      }
    }
    return table;
  }

  /** Who said what, when and in which voice. */
  private static Table words(List<Series> all) {
    Table table = new Table("run", "condition", "kappa", "t_s", "who", "voice", "text");
    for (Series series : all) {
      for (ExplorationRun run : series.runs()) {
        for (ExplorationRun.Line line : run.lines()) {
          table.add(
              run.number(),
              run.condition().key(),
              run.condition().kappa(),
              line.second(),
              line.who(),
              line.voice(),
              line.text());
        }
      }
    }
    return table;
  }
}
