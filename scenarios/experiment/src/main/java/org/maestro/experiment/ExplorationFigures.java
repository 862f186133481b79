package org.maestro.experiment;

import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Ink;
import org.maestro.experiment.drawing.Stacks;
import org.maestro.experiment.drawing.Whiskers;
import org.maestro.experiment.measuring.Interval;
import org.maestro.experiment.measuring.Share;
import org.maestro.experiment.measuring.Spread;

/** The figures of an exploration: endings, shares of success and times, and the robot's way. */
final class ExplorationFigures {
  private static final double PERCENT = 100;
  private static final double TICK = 0.1;
  private static final double ROOM_ABOVE = 1.15;

  /** Beside the points of the other condition, where those would hide it. */
  private static final double BESIDE = -0.02;

  private static final List<Stacks.Piece> ENDINGS =
      List.of(
          new Stacks.Piece("data sent", Ink.GREEN),
          new Stacks.Piece("the time was over", Ink.GREY));

  private final List<Exploration.Series> all;

  ExplorationFigures(List<Exploration.Series> all) {
    this.all = all;
  }

  List<Figure> drawn() {
    List<Figure> figures = new ArrayList<>();
    figures.add(
        Figure.of(
            "endings",
            "How the runs ended under each condition, with the same simulated subjects.",
            Stacks.draw(
                "How runs ended, with the same subjects",
                "runs",
                ENDINGS,
                all.stream()
                    .map(
                        series ->
                            new Stacks.Stack(
                                series.condition().label(),
                                List.of(
                                    series.successes().hits(),
                                    series.runs().size() - series.successes().hits())))
                    .toList())));
    figures.add(
        Figure.of(
            "success",
            "Share of runs in which data was sent, with the interval that holds the true share with 95 %, over what is assumed of subjects: by which share they think shorter once they hear a stressed voice.",
            chart("Data was sent", "runs (%)", PERCENT + 5, ExplorationFigures::success)));
    double longest = all.stream().mapToDouble(one -> one.times().greatest()).max().orElse(1);
    figures.add(
        Figure.of(
            "time",
            "Mean time of all runs with its 95 % interval; a run in which no data was sent counts with the whole time of the mission.",
            chart("Time of a run", "time (s)", longest * ROOM_ABOVE, ExplorationFigures::time)));
    all.stream()
        .flatMap(series -> series.runs().stream())
        .forEach(run -> figures.addAll(run.pictures()));
    return figures;
  }

  private BufferedImage chart(
      String title,
      String up,
      double greatest,
      Function<Exploration.Series, Whiskers.Point> point) {
    return Whiskers.draw(
        title,
        "κ, assumed",
        TICK,
        up,
        greatest,
        List.of(
            new Whiskers.Series("control", Ink.BLUE, points(false, point)),
            new Whiskers.Series("affect", Ink.ORANGE, points(true, point))));
  }

  private List<Whiskers.Point> points(
      boolean affect, Function<Exploration.Series, Whiskers.Point> point) {
    return all.stream().filter(series -> series.condition().affect() == affect).map(point).toList();
  }

  private static double at(Exploration.Series series) {
    return series.condition().affect() ? series.condition().kappa() : BESIDE;
  }

  private static Whiskers.Point success(Exploration.Series series) {
    Share share = series.successes();
    return new Whiskers.Point(
        at(series),
        PERCENT * share.value(),
        PERCENT * Math.max(0, share.least()),
        PERCENT * Math.min(1, share.greatest()));
  }

  private static Whiskers.Point time(Exploration.Series series) {
    Spread times = series.times();
    Interval interval = Interval.ofMean(times);
    boolean isKnown = times.count() > 1;
    return new Whiskers.Point(
        at(series),
        times.mean(),
        isKnown ? Math.max(0, interval.least()) : times.mean(),
        isKnown ? interval.greatest() : times.mean());
  }
}
