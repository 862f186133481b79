package org.maestro.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.page.Page;

/** The page of {@link MoveObject}. */
final class MovePage {
  private MovePage() {}

  static Page of(Request request, List<MoveRun> runs, List<MoveRun> paced, List<Figure> figures) {
    Page page =
        new Page(
            "Move object",
            "The paper's section 5.2: a green object is brought next to a red one, then a red one next to the green one. Where the objects are is not known at first; cameras look for them, and the light must be right for that.",
            request.command("move-object"));
    page.heading("Paper and measurement").comparison(rows(runs, paced));
    page.heading("Figures");
    figures.forEach(page::figure);
    page.heading("Runs that failed").table(List.of("run", "goal", "why"), failures(runs));
    page.heading("What was assumed").list(assumptions());
    page.heading("What differs from the paper, and why").list(differences());
    return page.settings(request.settings());
  }

  private static List<Page.Row> rows(List<MoveRun> runs, List<MoveRun> paced) {
    List<Page.Row> rows = new ArrayList<>();
    rows.add(
        new Page.Row(
            "time of a run",
            "about 42 s in the mean, little deviation",
            seconds(GoalRun.times(runs)),
            "mean, standard deviation, least and greatest of the runs that were reached"));
    rows.add(
        new Page.Row(
            "first half, green to red",
            "no failure is told of",
            GoalRun.reached(MoveObject.of(MoveObject.FIRST, runs)).text() + " reached",
            "judged from the simulated world"));
    rows.add(
        new Page.Row(
            "second half, red to green",
            "both failures: the robot heads for an occupied position",
            GoalRun.reached(MoveObject.of(MoveObject.SECOND, runs)).text() + " reached",
            "judged from the simulated world"));
    rows.add(
        new Page.Row(
            "claims that are not so",
            "not told",
            GoalRun.falseClaims(runs) + " of " + runs.size(),
            "the platform says reached, and the world says no"));
    Spread ratios = MoveObject.ratios(runs);
    rows.add(
        new Page.Row(
            "time over the physical lower bound",
            "not told",
            ratios.count() == 0
                ? "none was reached"
                : String.format(
                    Locale.ROOT,
                    "%.3f in the mean, %.3f at most",
                    ratios.mean(),
                    ratios.greatest()),
            "the bound knows everything at once: shortest way at full speed, one grip, one placing, one look for each object"));
    if (!paced.isEmpty()) {
      rows.add(
          new Page.Row(
              "the same on the paced clock, over the broker",
              "",
              GoalRun.reached(paced).text() + " reached; " + seconds(GoalRun.times(paced)),
              "decisions and messages take the time that they really take, times the speed of the clock"));
    }
    return rows;
  }

  static String seconds(Spread spread) {
    return spread.count() == 0
        ? "none was reached"
        : String.format(
            Locale.ROOT,
            "%.1f s ± %.1f s (%.1f to %.1f s)",
            spread.mean(),
            spread.deviation(),
            spread.least(),
            spread.greatest());
  }

  private static List<List<String>> failures(List<MoveRun> runs) {
    return runs.stream()
        .filter(run -> !run.success())
        .map(run -> List.of(String.valueOf(run.number()), run.job().goal(), run.failure()))
        .toList();
  }

  private static List<String> assumptions() {
    return List.of(
        "The paper gives no map with measures: the room is 8.4 m by 3 m, with three ceiling cameras of 75 degrees at 2.8 m, which together see all of it, six lamps, one light sensor.",
        "The windows are our assumption: two to the south, 1.4 m wide, 0.9 to 2.1 m high, at Minden's latitude on the day of the equinox; the paper says only that the light upon an object was too high.",
        "Before each run the objects are put to the same places by hand, not quite exactly, and the robot to the middle; lamps are off and shutters open. The goal comes 20 s later: by then the building's own agents have seen to the light, with lamps, and with shutters against the sun where there are any.",
        "The lower bound knows where everything is and that the light is right: shortest way at full speed, placing at the greatest distance that still counts, one grip, one placing, one look of five frames for each object. It counts no decision, no message, no look that finds nothing, and no look that confirms the end.",
        "The robot drives at 0.8 m/s, which is the youBot's data sheet, without getting up to speed; a grip takes 4 s, a placing 3 s (the table of parameters names the sources).",
        "Its gripper is a bag of grains that holds what it can wrap; the paper names the kind, and nothing of its size: a ball of 10 cm, its pinch and its friction are assumed (world.gripper).",
        "A decision of the platform costs 20 ms, messages cost what the stepped clock states.",
        "What is not carried stands for Bob, whom nobody carries; so the direction is certain.");
  }

  private static List<String> differences() {
    return List.of(
        "The paper's runs take longer. It gives no speeds; a real base speeds up, slows down, and is driven slower than its data sheet near objects and walls. Here 0.8 m/s is driven from corner to corner. Nothing was set so that 42 s come out; --set world.base.speed=0.2 shows how the time depends on it.",
        "Which run fails depends on where the sun shines at its hour and on clouds of its own seed, not on which half it belongs to.",
        "A camera here refuses to say \"not there\" when light does not allow it, and names the light; the paper's cameras took the wrong object then.");
  }
}
