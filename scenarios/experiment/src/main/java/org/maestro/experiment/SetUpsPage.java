package org.maestro.experiment;

import java.util.List;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.page.Page;

/** The page on which set-ups are compared. */
final class SetUpsPage {
  private SetUpsPage() {}

  static Page of(Request request, Comparison comparison, Compared compared, List<Figure> figures) {
    Page page =
        new Page(
            "Set-ups compared",
            "The same goals in %s: each run has the same seed in each of them, whether a goal is reached is judged by the simulated world, and nothing is tuned."
                .formatted(String.join(", ", compared.names())),
            request.command(SetUps.NAME) + comparison.given());
    Table table = SetUps.comparison(compared);
    page.heading("What is shown").list(compared.claims());
    page.heading("The table").table(table.columns(), table.rows());
    page.heading("What could not be done, and why")
        .table(
            List.of("home", "goal", "runs", "why"),
            compared.undone().stream()
                .map(
                    undone ->
                        List.of(
                            undone.home(),
                            undone.goal(),
                            String.valueOf(undone.runs()),
                            undone.why()))
                .toList());
    page.heading("What was wanted")
        .table(
            List.of("goal", "stated"),
            compared.wishes().stream()
                .map(
                    wish ->
                        List.of(
                            wish.goal(),
                            wish.at()
                                .map(at -> at.toMillis() / 1e3 + " s after the evening's begin")
                                .orElse("when all before it had ended")))
                .toList());
    page.heading("Figures");
    figures.forEach(page::figure);
    page.heading("How it was measured")
        .list(
            List.of(
                "A goal is judged the moment it ends, by where everything is, how bright it is and"
                    + " how devices are set in the simulated world. Light within 4 % of what was"
                    + " wanted counts, as sensors err by 3 %. What the world cannot tell, such as"
                    + " whether a script was carried out, counts as the platform says.",
                "Shares are compared by Newcombe's interval from Wilson's, as if their runs were"
                    + " not in pairs; times, energy and light by Student's interval of the"
                    + " differences of runs with the same seed. Each interval holds with 95 % by"
                    + " itself: of twenty that are looked at one may leave out 0 by chance. An"
                    + " interval without width says that all runs agree.",
                "Times of a goal are compared in runs in which both homes have reached it; the time"
                    + " of the evening and its energy in runs in which both have reached the same"
                    + " goals, since who gives up is soon done.",
                "Energy is what lamps and appliances draw that state their power, and what robots'"
                    + " batteries give; light is at the reference points of zones that all homes"
                    + " have. Both are read once a second.",
                "The physics is that of a simulation; what it assumes stands in the table below."));
    return page.settings(request.settings());
  }
}
