package org.maestro.experiment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import org.maestro.experiment.drawing.Bars;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.Timeline;
import org.maestro.experiment.measuring.Share;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.page.Page;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;

/**
 * The example of the paper's introduction: a sensor robot inspects a broken cup, a gripper robot
 * collects its shards, a vacuum robot takes the rest.
 */
final class BrokenCup implements Experiment {

  /**
   * There are no cameras, sensors, lamps, nor windows; what is where another robot tells without
   * error. The only robot with a battery cannot charge it, whatever it tells of it.
   */
  private static final String[] IDLE = {
    "world.scanner.range",
    "world.shutters",
    "world.camera.",
    "world.colour.",
    "world.image.",
    "world.sensor.",
    "world.facade.",
    "world.lamp.",
    "world.arm.graspTolerance",
    "world.battery.worthTelling",
    "world.drives."
  };

  @Override
  public String name() {
    return "broken-cup";
  }

  @Override
  public String purpose() {
    return "one robot inspects, one collects the shards, one vacuums (section 1)";
  }

  @Override
  public int usualRuns() {
    return 10;
  }

  @Override
  public List<Setting> settings() {
    return Physics.settingsWithout(IDLE);
  }

  @Override
  public Course<?> begin(Request request) {
    return new Course<>(
        request.runs(),
        run -> CupRun.carryOut(run, request.seedOf(run), request.settings()),
        run ->
            String.format(
                Locale.ROOT,
                "%s in %.1f s",
                run.success() ? "cleaned up" : "not cleaned up",
                run.seconds()),
        runs -> findings(request, runs));
  }

  private Findings findings(Request request, List<CupRun> runs) {
    Map<String, Table> tables = new LinkedHashMap<>();
    tables.put("runs", GoalRun.table(runs));
    tables.put("deeds", deeds(runs));
    tables.put("steps", steps(runs));
    tables.put("story", GoalRun.story(runs));
    List<Figure> figures = figures(runs);
    Share reached = GoalRun.reached(runs);
    Spread times = GoalRun.times(runs);
    return new Findings(
        name(),
        List.of(
            new Findings.Result("runs", runs.size(), ""),
            new Findings.Result("cleaned up, in the simulated world", reached.hits(), ""),
            new Findings.Result("time, mean", times.mean(), "s")),
        tables,
        figures,
        page(request, runs, reached, times, figures));
  }

  private static Table deeds(List<CupRun> runs) {
    Table table = new Table("run", "t_s", "robot", "deed");
    runs.forEach(
        run ->
            run.deeds()
                .forEach(
                    deed -> table.add(run.number(), deed.second(), deed.robot(), deed.what())));
    return table;
  }

  private static Table steps(List<CupRun> runs) {
    Table table = new Table("run", "agent", "step", "begin_s", "end_s", "done");
    runs.forEach(
        run ->
            Steps.of(run.ending())
                .forEach(
                    step ->
                        table.add(
                            run.number(),
                            step.who(),
                            step.what(),
                            step.begin(),
                            step.end(),
                            step.done())));
    return table;
  }

  private static List<Figure> figures(List<CupRun> runs) {
    List<Figure> figures = new ArrayList<>();
    figures.add(
        Figure.of(
            "times",
            "Time of each run, from the goal to the report of the vacuum robot.",
            Bars.draw(
                "Time until the cup is cleaned up",
                "run",
                "time (s)",
                runs.stream()
                    .map(
                        run ->
                            new Bars.Bar(
                                run.seconds(),
                                "cleaned up",
                                Ink.GREEN,
                                !run.success(),
                                OptionalDouble.empty()))
                    .toList(),
                mean(GoalRun.times(runs)),
                "")));
    List<Timeline.Deed> steps = Steps.of(runs.get(0).ending());
    if (!steps.isEmpty()) {
      figures.add(
          Figure.of(
              "timeline",
              "Which agent did what when, in run 1: each step of the plan, from the agent's order to its report.",
              Timeline.draw("Who did what when, run 1", "time since the goal (s)", steps)));
    }
    runs.forEach(run -> figures.addAll(run.pictures()));
    return figures;
  }

  private static List<Bars.Level> mean(Spread times) {
    return times.count() == 0
        ? List.of()
        : List.of(
            new Bars.Level(
                times.mean(),
                String.format(Locale.ROOT, "mean of runs cleaned up: %.1f s", times.mean()),
                Ink.BLUE));
  }

  private static Page page(
      Request request, List<CupRun> runs, Share reached, Spread times, List<Figure> figures) {
    Page page =
        new Page(
            "The broken cup",
            "The paper's introduction: a cup is broken; a robot with sensors checks it, a robot with a gripper collects the shards, a vacuum robot takes the rest. The goal is one sentence: the cup is cleaned up. Who does what, and in which order, the planner finds from what the robots say of themselves; the words for it stand in the home's file alone.",
            request.command("broken-cup"));
    page.heading("Paper and measurement")
        .comparison(
            List.of(
                new Page.Row(
                    "three robots, in that order",
                    "an example; not carried out",
                    reached.text() + " cleaned up in that order",
                    "judged from what robots did in the simulated world and from where the shards lie"),
                new Page.Row(
                    "time",
                    "not told",
                    times.count() == 0
                        ? "none was cleaned up"
                        : String.format(
                            Locale.ROOT, "%.1f s ± %.1f s", times.mean(), times.deviation()),
                    "")));
    page.heading("Figures");
    figures.forEach(page::figure);
    page.heading("What was done in run 1")
        .table(
            List.of("at (s)", "robot", "deed"),
            runs.get(0).deeds().stream()
                .map(
                    deed ->
                        List.of(
                            String.format(Locale.ROOT, "%.1f", deed.second()),
                            deed.robot(),
                            deed.what()))
                .toList());
    page.heading("Runs that failed")
        .table(
            List.of("run", "why"),
            runs.stream()
                .filter(run -> !run.success())
                .map(run -> List.of(String.valueOf(run.number()), run.failure()))
                .toList());
    page.heading("What was assumed")
        .list(
            List.of(
                "Sensor robot and vacuum robot are members that no driver of the simulation knows: they go straight at 0.5 m/s to what a call is about, and work there for the time that their description states.",
                "The sensor robot sees whether the cup is broken, and where a shard lies, without error.",
                "The shards lie where they fell, not quite the same in each run. lower_bound_s is empty: no bound was reckoned."));
    return page.settings(request.settings());
  }
}
