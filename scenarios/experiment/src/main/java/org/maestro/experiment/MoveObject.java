package org.maestro.experiment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;
import org.maestro.ontology.floor.Point2;

/** The paper's section 5.2: one object is brought to another, first one way, then the other. */
final class MoveObject implements Experiment {
  static final MoveRun.Job FIRST = new MoveRun.Job("GreenObject", "RedObject1");
  static final MoveRun.Job SECOND = new MoveRun.Job("RedObject1", "GreenObject");
  private static final String PACE = "paced.speed";
  private static final int PACED_RUNS = 20;

  /** There is one robot, and it cannot charge its battery, whatever it tells of it. */
  static final String IDLE = "world.battery.worthTelling";

  /** Of the trail's samples every fifth is written: ten a second. */
  private static final int TRAIL_STRIDE = 5;

  @Override
  public String name() {
    return "move-object";
  }

  @Override
  public String purpose() {
    return "an object is brought to another, 10 times one way, 10 times the other (figures 9 to"
        + " 12)";
  }

  @Override
  public int usualRuns() {
    return 20;
  }

  @Override
  public List<Setting> settings() {
    List<Setting> settings = new ArrayList<>(Laboratory.settings());
    settings.addAll(MoveRun.settings());
    settings.addAll(Physics.settingsWithout(IDLE));
    settings.add(
        Setting.number(
            PACE, 4, 0.1, 100, "simulated seconds per second of wall time with --paced"));
    return settings;
  }

  @Override
  public boolean canBePaced() {
    return true;
  }

  /** A run, and on which clock it was. */
  private record Timed(MoveRun run, boolean paced) {}

  @Override
  public Course<?> begin(Request request) {
    int stepped = request.runs();
    int paced = request.paced() ? PACED_RUNS : 0;
    OptionalDouble pace = OptionalDouble.of(request.settings().number(PACE));
    return new Course<>(
        stepped + paced,
        run ->
            run <= stepped
                ? new Timed(run(request, run, stepped, OptionalDouble.empty()), false)
                : new Timed(run(request, run - stepped, paced, pace), true),
        timed -> (timed.paced() ? "paced: " : "") + line(timed.run()),
        runs -> findings(request, on(false, runs), on(true, runs)));
  }

  private static List<MoveRun> on(boolean paced, List<Timed> runs) {
    return runs.stream().filter(timed -> timed.paced() == paced).map(Timed::run).toList();
  }

  private static MoveRun run(Request request, int run, int of, OptionalDouble pace) {
    boolean drawn = pace.isEmpty() && (run == 1 || run == of / 2 + 1);
    return MoveRun.carryOut(
        run,
        request.seedOf(run),
        2 * run <= of + 1 ? FIRST : SECOND,
        request.settings(),
        pace,
        drawn);
  }

  private static String line(MoveRun run) {
    return String.format(
        Locale.ROOT,
        "%s, %.1f s (bound %.1f s), %d replans",
        run.success() ? "reached" : "failed",
        run.seconds(),
        run.boundSeconds(),
        run.ending().replans());
  }

  private static Findings findings(Request request, List<MoveRun> runs, List<MoveRun> paced) {
    Map<String, Table> tables = new LinkedHashMap<>();
    tables.put("runs", GoalRun.table(runs));
    tables.put("details", details(runs));
    tables.put("trail", trail(runs));
    tables.put("story", GoalRun.story(runs));
    if (!paced.isEmpty()) {
      tables.put("paced", GoalRun.table(paced));
    }
    List<Figure> figures = MoveFigures.of(runs, paced);
    return new Findings(
        "move-object",
        results(runs, paced),
        tables,
        figures,
        MovePage.of(request, runs, paced, figures));
  }

  private static List<Findings.Result> results(List<MoveRun> runs, List<MoveRun> paced) {
    List<Findings.Result> results = new ArrayList<>();
    results.add(new Findings.Result("runs", runs.size(), ""));
    results.add(
        new Findings.Result("reached, in the simulated world", GoalRun.reached(runs).hits(), ""));
    results.add(new Findings.Result("claims that were not so", GoalRun.falseClaims(runs), ""));
    results.add(
        new Findings.Result(
            "time of a run that was reached, mean", GoalRun.times(runs).mean(), "s"));
    results.add(
        new Findings.Result("the same, standard deviation", GoalRun.times(runs).deviation(), "s"));
    results.add(
        new Findings.Result("time over its physical lower bound, mean", ratios(runs).mean(), ""));
    if (!paced.isEmpty()) {
      results.add(new Findings.Result("paced: reached", GoalRun.reached(paced).hits(), ""));
      results.add(
          new Findings.Result("paced: time of a run, mean", GoalRun.times(paced).mean(), "s"));
    }
    return results;
  }

  static Spread ratios(List<MoveRun> runs) {
    return Spread.of(runs.stream().filter(MoveRun::success).mapToDouble(MoveRun::ratio).toArray());
  }

  static List<MoveRun> of(MoveRun.Job job, List<MoveRun> runs) {
    return runs.stream().filter(run -> run.job().equals(job)).toList();
  }

  static Table details(List<MoveRun> runs) {
    Table table =
        new Table(
            "run",
            "solar_hours",
            "brightest_object_lux",
            "claimed",
            "confirmed",
            "false_claim",
            "calls",
            "driven_m",
            "apart_m",
            "ratio",
            "carried");
    runs.forEach(
        run ->
            table.add(
                run.number(),
                run.solarHours(),
                run.brightestLux(),
                run.ending().claimed(),
                run.ending().report().filter(report -> report.confirmed()).isPresent(),
                run.falseClaim(),
                run.ending().calls(),
                run.trail().length(),
                run.apartMetres(),
                run.ratio(),
                String.join(" ", run.moved())));
    return table;
  }

  private static Table trail(List<MoveRun> runs) {
    Table table = new Table("run", "t_s", "x_m", "y_m");
    for (MoveRun run : runs) {
      double step = run.trail().step().toMillis() / 1e3;
      List<Point2> places = run.trail().places();
      for (int i = 0; i < places.size(); i += TRAIL_STRIDE) {
        table.add(run.number(), i * step, places.get(i).x(), places.get(i).y());
      }
    }
    return table;
  }
}
