package org.maestro.experiment;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import org.maestro.coordination.api.Ports;
import org.maestro.experiment.drawing.Bars;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.Stacks;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.page.Page;
import org.maestro.experiment.setting.Physics;
import org.maestro.experiment.setting.Setting;

/**
 * Agents come, go and fail while goals are pursued: with plans that are made again, and with a
 * fixed plan. The paper's section 6 claims flexibility and reliability.
 */
final class JoinLeave implements Experiment {
  private static final List<Stacks.Piece> ENDINGS =
      List.of(
          new Stacks.Piece("reached", Ink.GREEN),
          new Stacks.Piece("not reached, and says so", Ink.GREY),
          new Stacks.Piece("claims what is not so", Ink.RED));

  /**
   * There are no windows, no pictures are taken nor looked at, and all lamps that are needed shine
   * from the beginning on: none was raised in any of the runs that were looked at.
   */
  private static final String[] IDLE = {
    "world.shutters",
    "world.camera.width",
    "world.camera.height",
    "world.camera.fromPixels",
    "world.camera.detectionWidth",
    "world.image.",
    "world.facade.",
    "world.lamp.",
    "world.drives."
  };

  @Override
  public String name() {
    return "join-leave";
  }

  @Override
  public String purpose() {
    return "agents come, go and fail during the goals; against a fixed plan (section 6)";
  }

  @Override
  public int usualRuns() {
    return 100;
  }

  @Override
  public List<Setting> settings() {
    return Physics.settingsWithout(IDLE);
  }

  @Override
  public Course<?> begin(Request request) {
    return new Course<>(
        request.runs(),
        run -> inEachWay(request, run),
        ways ->
            "%s with %d replans; fixed plan %s"
                .formatted(
                    reached(of(ways, JoinRun.Way.REPLANNING)),
                    of(ways, JoinRun.Way.REPLANNING).ending().replans(),
                    reached(of(ways, JoinRun.Way.FIXED_PLAN))),
        runs -> findings(request, byWay(runs)));
  }

  private static Map<JoinRun.Way, JoinRun> inEachWay(Request request, int run) {
    Map<JoinRun.Way, JoinRun> ways = new EnumMap<>(JoinRun.Way.class);
    for (JoinRun.Way way : JoinRun.Way.values()) {
      ways.put(way, JoinRun.carryOut(run, request.seedOf(run), way, request.settings()));
    }
    return ways;
  }

  private static String reached(JoinRun run) {
    return run.success() ? "reached" : "not reached";
  }

  private static JoinRun of(Map<JoinRun.Way, JoinRun> ways, JoinRun.Way way) {
    return Objects.requireNonNull(ways.get(way));
  }

  private static Map<JoinRun.Way, List<JoinRun>> byWay(List<Map<JoinRun.Way, JoinRun>> runs) {
    Map<JoinRun.Way, List<JoinRun>> byWay = new EnumMap<>(JoinRun.Way.class);
    for (JoinRun.Way way : JoinRun.Way.values()) {
      byWay.put(way, runs.stream().map(ways -> of(ways, way)).toList());
    }
    return byWay;
  }

  /** Each way has its runs. */
  private static List<JoinRun> by(JoinRun.Way way, Map<JoinRun.Way, List<JoinRun>> runs) {
    return Objects.requireNonNull(runs.get(way));
  }

  private static Findings findings(Request request, Map<JoinRun.Way, List<JoinRun>> runs) {
    Map<String, Table> tables = new LinkedHashMap<>();
    tables.put("runs", table(runs));
    tables.put("story", GoalRun.story(by(JoinRun.Way.REPLANNING, runs)));
    List<Figure> figures = figures(runs);
    List<Findings.Result> results = new ArrayList<>();
    results.add(new Findings.Result("goals", by(JoinRun.Way.REPLANNING, runs).size(), ""));
    for (JoinRun.Way way : JoinRun.Way.values()) {
      results.add(
          new Findings.Result(
              words(way) + ": reached", GoalRun.reached(by(way, runs)).hits(), "goals"));
    }
    results.add(
        new Findings.Result(
            "claims that were not so",
            runs.values().stream().flatMap(List::stream).filter(JoinRun::falseClaim).count(),
            ""));
    results.add(new Findings.Result("plans made again, mean", replans(runs).mean(), ""));
    results.add(
        new Findings.Result(
            "added time of reached goals, mean", Spread.of(added(runs)).mean(), "s"));
    return new Findings("join-leave", results, tables, figures, page(request, runs, figures));
  }

  private static Spread replans(Map<JoinRun.Way, List<JoinRun>> runs) {
    return Spread.of(
        by(JoinRun.Way.REPLANNING, runs).stream()
            .mapToDouble(run -> run.ending().replans())
            .toArray());
  }

  /** Seconds more than undisturbed, of goals that were reached both times. */
  private static double[] added(Map<JoinRun.Way, List<JoinRun>> runs) {
    List<Double> added = new ArrayList<>();
    List<JoinRun> undisturbed = by(JoinRun.Way.UNDISTURBED, runs);
    List<JoinRun> replanning = by(JoinRun.Way.REPLANNING, runs);
    for (int i = 0; i < replanning.size(); i++) {
      if (replanning.get(i).success() && undisturbed.get(i).success()) {
        added.add(replanning.get(i).seconds() - undisturbed.get(i).seconds());
      }
    }
    return added.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static String words(JoinRun.Way way) {
    return switch (way) {
      case UNDISTURBED -> "undisturbed";
      case REPLANNING -> "planning again";
      case FIXED_PLAN -> "fixed plan";
    };
  }

  private static Table table(Map<JoinRun.Way, List<JoinRun>> runs) {
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
            "way",
            "claimed",
            "events");
    for (JoinRun.Way way : JoinRun.Way.values()) {
      List<JoinRun> undisturbed = by(JoinRun.Way.UNDISTURBED, runs);
      for (int i = 0; i < by(way, runs).size(); i++) {
        JoinRun run = by(way, runs).get(i);
        table.add(
            run.number(),
            run.seed(),
            run.goal(),
            run.success(),
            run.seconds(),
            undisturbed.get(i).seconds(),
            run.ending().replans(),
            run.failure(),
            way.name().toLowerCase(Locale.ROOT),
            run.ending().claimed(),
            run.comings().text());
      }
    }
    return table;
  }

  private static List<Figure> figures(Map<JoinRun.Way, List<JoinRun>> runs) {
    List<Figure> figures = new ArrayList<>();
    figures.add(
        Figure.of(
            "endings",
            "How the goals ended: undisturbed; with members that come, go and fail, plans being"
                + " made again; and with a fixed plan, under the same events.",
            Stacks.draw(
                "How goals ended while agents came and went",
                "goals",
                ENDINGS,
                runs.entrySet().stream()
                    .map(
                        entry ->
                            new Stacks.Stack(
                                words(entry.getKey()), GoalRun.counts(entry.getValue())))
                    .toList())));
    List<Bars.Bar> bars =
        by(JoinRun.Way.REPLANNING, runs).stream()
            .sorted(Comparator.comparingDouble(JoinRun::seconds))
            .map(
                run ->
                    new Bars.Bar(
                        run.seconds(),
                        run.ending().replans() == 0 ? "no plan made again" : "planned again",
                        run.ending().replans() == 0 ? Ink.SKY : Ink.ORANGE,
                        !run.success(),
                        OptionalDouble.empty()))
            .toList();
    double mean =
        Spread.of(
                by(JoinRun.Way.UNDISTURBED, runs).stream().mapToDouble(JoinRun::seconds).toArray())
            .mean();
    figures.add(
        Figure.of(
            "times",
            "Time of each goal while agents come and go, in the order of their times; hatched with"
                + " a cross: not reached. The line is the mean time of the same goals undisturbed.",
            Bars.draw(
                "Time of each goal while agents come and go",
                "goal, by its time",
                "time (s)",
                bars,
                List.of(
                    new Bars.Level(
                        mean,
                        String.format(Locale.ROOT, "mean undisturbed: %.1f s", mean),
                        Ink.BLUE)),
                "")));
    return figures;
  }

  /** Nothing is not below nothing. */
  private static double tenths(double seconds) {
    return Math.round(10 * seconds) / 10.0 + 0.0;
  }

  private static Page page(
      Request request, Map<JoinRun.Way, List<JoinRun>> runs, List<Figure> figures) {
    Page page =
        new Page(
            "Agents come and go",
            "The paper's sections 1 and 6: agents can be added and removed at run time, and the"
                + " system as a whole is more flexible and reliable. Here a cup is to be brought to"
                + " Bob by one of two robots, while robots, cameras, lamps and sensors fail, leave"
                + " the bus, return, and join. The same events meet a platform that plans again,"
                + " and a fixed plan.",
            request.command("join-leave"));
    Spread added = Spread.of(added(runs));
    page.heading("Paper and measurement")
        .comparison(
            List.of(
                new Page.Row(
                    "goals reached while agents come and go",
                    "\"more flexible and reliable\", without figures",
                    GoalRun.reached(by(JoinRun.Way.REPLANNING, runs)).text(),
                    "judged from the simulated world"),
                new Page.Row(
                    "the same with a fixed plan",
                    "not told",
                    GoalRun.reached(by(JoinRun.Way.FIXED_PLAN, runs)).text(),
                    "the platform's own first plan, everything being known, followed until a step"
                        + " fails or the rest is impossible"),
                new Page.Row(
                    "undisturbed",
                    "not told",
                    GoalRun.reached(by(JoinRun.Way.UNDISTURBED, runs)).text(),
                    "the same goals without events"),
                new Page.Row(
                    "plans made again",
                    "not told",
                    String.format(
                        Locale.ROOT,
                        "%.2f a goal, %.0f at most",
                        replans(runs).mean(),
                        replans(runs).greatest()),
                    ""),
                new Page.Row(
                    "added time",
                    "not told",
                    added.count() == 0
                        ? "none was reached"
                        : String.format(
                            Locale.ROOT,
                            "%.1f s in the mean, %.1f s at most",
                            tenths(added.mean()),
                            tenths(added.greatest())),
                    "of goals that were reached, against the same goal undisturbed")));
    page.heading("Figures");
    figures.forEach(page::figure);
    page.heading("Goals that were not reached, plans being made again")
        .table(
            List.of("goal", "what happened", "why"),
            by(JoinRun.Way.REPLANNING, runs).stream()
                .filter(run -> !run.success())
                .map(
                    run ->
                        List.of(String.valueOf(run.number()), run.comings().text(), run.failure()))
                .toList());
    page.heading("What was assumed")
        .list(
            List.of(
                "Bob's home with two robots. Half of the time the second robot is away at first and"
                    + " joins within 12 s. Then one to three members, half of them robots, fail or"
                    + " leave the bus within 12 s, about what a goal takes; four of ten come back"
                    + " within 12 s more.",
                "Each goal begins on a platform of its own that has seen cup and Bob, so that the"
                    + " fixed plan needs no search and both ways meet the same.",
                String.format(
                    Locale.ROOT,
                    "A goal that needs a member which was lost moments ago waits for it, %d s from"
                        + " the loss at most, as people would; the fixed plan has no such rule,"
                        + " since it ends with its first step that cannot be done.",
                    Ports.USUAL_COMEBACK.toSeconds()),
                "Some events leave nothing that could be done: no robot, or no light. Such goals"
                    + " count as not reached here, too."));
    page.heading("What differs from the paper, and why")
        .list(
            List.of(
                "The paper gives no figures for what it claims in section 6; the fixed plan is our"
                    + " reading of what it is compared with.",
                "lower_bound_s in runs.csv is the time of the same goal undisturbed."));
    return page.settings(request.settings());
  }
}
