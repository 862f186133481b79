package org.maestro.experiment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.experiment.drawing.Bars;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.drawing.Heat;
import org.maestro.experiment.drawing.Ink;
import org.maestro.ontology.floor.Point2;

/** The figures of {@link MoveObject}. */
final class MoveFigures {
  private static final double STEP_SECONDS = MoveRun.TRAIL_STEP.toMillis() / 1e3;

  private MoveFigures() {}

  static List<Figure> of(List<MoveRun> runs, List<MoveRun> paced) {
    List<Figure> figures = new ArrayList<>();
    figures.add(
        bars(
            "execution-time",
            "Time of each run",
            "Time of each run (compare figure 10). A hatched bar with a cross is a run that was not reached in the simulated world. The dash is the run's physical lower bound: shortest way at full speed, one grip, one placing, one look for each object.",
            runs));
    if (!paced.isEmpty()) {
      figures.add(
          bars(
              "execution-time-paced",
              "The same on the paced clock over the MQTT broker",
              "The same runs on the paced clock, over the real broker.",
              paced));
    }
    double greatest = Math.max(greatest(MoveObject.FIRST, runs), greatest(MoveObject.SECOND, runs));
    heat("heat", "", "11", MoveObject.FIRST, runs, greatest).ifPresent(figures::add);
    heat("heat", "", "12", MoveObject.SECOND, runs, greatest).ifPresent(figures::add);
    runs.forEach(run -> figures.addAll(run.pictures()));
    return figures;
  }

  private static Figure bars(String name, String title, String caption, List<MoveRun> runs) {
    List<Bars.Bar> bars =
        runs.stream()
            .map(
                run ->
                    new Bars.Bar(
                        run.seconds(),
                        words(run.job()),
                        run.job().equals(MoveObject.FIRST) ? Ink.GREEN : Ink.RED,
                        !run.success(),
                        OptionalDouble.of(run.boundSeconds())))
            .toList();
    double mean = GoalRun.times(runs).mean();
    List<Bars.Level> levels =
        Double.isNaN(mean)
            ? List.of()
            : List.of(
                new Bars.Level(
                    mean,
                    String.format(Locale.ROOT, "mean of reached runs: %.1f s", mean),
                    Ink.BLUE));
    return Figure.of(
        name, caption, Bars.draw(title, "run", "time (s)", bars, levels, "physical lower bound"));
  }

  private static String words(MoveRun.Job job) {
    return job.equals(MoveObject.FIRST) ? "green to red" : "red to green";
  }

  private static List<Point2> places(MoveRun.Job job, List<MoveRun> runs) {
    return MoveObject.of(job, runs).stream().flatMap(run -> run.trail().places().stream()).toList();
  }

  /** The longest that the robot was in one place; seconds. */
  static double greatest(MoveRun.Job job, List<MoveRun> runs) {
    return Heat.greatest(Laboratory.WIDTH, Laboratory.DEPTH, places(job, runs), STEP_SECONDS);
  }

  /**
   * Where the robot was.
   *
   * @param name with which the figure's begins
   * @param lead with which its caption begins
   * @param ofPaper the paper's figure with which it is to be compared
   * @param greatest seconds of the brightest colour
   * @return empty when there was no such run
   */
  static Optional<Figure> heat(
      String name,
      String lead,
      String ofPaper,
      MoveRun.Job job,
      List<MoveRun> runs,
      double greatest) {
    List<MoveRun> half = MoveObject.of(job, runs);
    if (half.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        Figure.of(
            name + "-" + words(job).replace(' ', '-'),
            "%sWhere the robot was during %s %s, all added up (compare figure %s). Rings: where it and the two objects were put at first, about."
                .formatted(lead, counted(half), words(job), ofPaper),
            Heat.draw(
                "Where the robot was, %s, %s".formatted(words(job), counted(half)),
                Laboratory.WIDTH,
                Laboratory.DEPTH,
                places(job, runs),
                STEP_SECONDS,
                marks(half.get(0)),
                greatest)));
  }

  private static String counted(List<MoveRun> runs) {
    return runs.size() == 1 ? "one run" : runs.size() + " runs";
  }

  private static Map<String, Point2> marks(MoveRun run) {
    Map<String, Point2> marks = new LinkedHashMap<>();
    marks.put("robot", run.trail().places().get(0));
    marks.put("green", new Point2(1.2, 2.0));
    marks.put("red", new Point2(7.2, 1.1));
    return marks;
  }
}
