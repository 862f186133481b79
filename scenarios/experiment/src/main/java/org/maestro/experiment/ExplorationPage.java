package org.maestro.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.measuring.Interval;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.page.Page;

/** The page of an exploration: what was measured, on what it rests, and what is not claimed. */
final class ExplorationPage {
  private ExplorationPage() {}

  static Page of(Request request, List<Exploration.Series> all, List<Figure> figures) {
    Page page =
        new Page(
            "Exploration by words, and affect in the robot's voice",
            "The ADE paper's section 4: a subject directs a robot by words (\"turn right\", \"go straight\") to a place from which it can transmit, and asks for readings of the signal. After a fixed time the robot reports that its battery is low, and how much time is left; in one condition its voice is stressed from then on. Here a program stands for the subject. Nothing on this page is a statement about people.",
            request.command(Exploration.NAME));
    page.notice(
        "κ is an assumption: by which share a simulated subject thinks shorter once it has heard a stressed voice. It was not measured. What grows with κ shows that the platform carries the affect from a script of the home to who listens, and nothing else.");
    page.heading("Paper and measurement").comparison(rows(all));
    agreement(all).ifPresent(page::text);
    page.heading("Each assumption")
        .table(
            List.of(
                "condition",
                "data sent",
                "time of all runs, mean",
                "time of runs with success, mean",
                "longer than control, the same subjects",
                "heard a stressed voice",
                "utterances, mean"),
            all.stream().map(series -> row(series, control(all))).toList());
    page.heading("Figures");
    figures.forEach(page::figure);
    page.heading("What was assumed").list(assumptions());
    page.heading("What this shows, and what it does not").list(meaning());
    return page.settings(request.settings());
  }

  private static Optional<Exploration.Series> control(List<Exploration.Series> all) {
    return all.stream().filter(series -> !series.condition().affect()).findFirst();
  }

  private static List<Page.Row> rows(List<Exploration.Series> all) {
    List<Page.Row> rows = new ArrayList<>();
    for (Exploration.Series series : all) {
      rows.add(
          new Page.Row(
              series.condition().label(),
              series.condition().affect()
                  ? "better than control in success rate and time, without figures"
                  : "no figures",
              "data sent in %s; %s".formatted(series.successes().text(), seconds(series.times())),
              series.condition().affect()
                  ? "the paper's subjects were people; here κ says how a program behaves"
                  : "neutral voice; κ has no effect, as nobody hears stress"));
    }
    return rows;
  }

  /** Of the condition in which affect is expressed and changes nothing. */
  private static Optional<String> agreement(List<Exploration.Series> all) {
    Optional<Exploration.Series> unmoved =
        all.stream()
            .filter(series -> series.condition().affect() && series.condition().kappa() == 0)
            .findFirst();
    return control(all)
        .flatMap(
            control ->
                unmoved.map(
                    other ->
                        other.agreesWith(control)
                            ? "With κ = 0 a stressed voice changes nothing, and both conditions agree within their intervals."
                            : "With κ = 0 a stressed voice should change nothing, but the conditions do not agree within their intervals: the expression itself has an effect that it should not have."));
  }

  private static List<String> row(Exploration.Series series, Optional<Exploration.Series> control) {
    return List.of(
        series.condition().label(),
        series.successes().text(),
        seconds(series.times()),
        seconds(series.timesOfSuccesses()),
        control
            .filter(other -> series.condition().affect())
            .map(series::longerThan)
            .map(ExplorationPage::seconds)
            .orElse(""),
        "%d of %d"
            .formatted(
                series.runs().stream().filter(ExplorationRun::isStressHeard).count(),
                series.runs().size()),
        String.format(
            Locale.ROOT,
            "%.1f",
            Spread.of(series.runs().stream().mapToDouble(ExplorationRun::utterances).toArray())
                .mean()));
  }

  private static String seconds(Spread spread) {
    if (spread.count() == 0) {
      return "none";
    }
    Interval interval = Interval.ofMean(spread);
    return spread.count() == 1
        ? String.format(Locale.ROOT, "%.1f s", spread.mean())
        : String.format(
            Locale.ROOT,
            "%.1f s (95 %% interval %.1f to %.1f s)",
            spread.mean(),
            interval.least(),
            interval.greatest());
  }

  private static List<String> assumptions() {
    return List.of(
        "κ, as said above; it is varied, not fitted.",
        "The subject: it knows how strong the signal has to be (80), goes on where readings grow, turns aside or back where they do not, and errs in a tenth of its turns and comparisons (subject.errors). Before it says anything it takes 1 s at least and 4 s in the mean (subject.delay). The paper tells nothing of its subjects' ways.",
        "The place: a crater of 20 m by 20 m with three rocks; the paper tells no measures. The signal has one peak, at a place that the seed draws, and falls as 1 / (1 + (d / 5 m)²) of 100 (world.signal).",
        "The robot drives at 0.7 m/s and turns by 90 degrees a second; before a rock it stands still by itself.",
        "The mission: the first report after 120 s, then one each 30 s, the end after 300 s. The paper says \"after a fixed period of time\". Who directs the robot is not told of it before the first report.",
        "A run in which no data was sent counts with 300 s in the time of all runs.");
  }

  private static List<String> meaning() {
    return List.of(
        "A run with success shows that the chain works to its end: words are understood, the robot drives by them and stops before what is in its way, the field beside the platform is asked for readings, and the robot sends its data where it may, as the simulated world says.",
        "The column of those who heard a stressed voice shows how far the mood that a script expresses reaches who listens. Who is done before the second report hears none in either condition.",
        "In control nobody hears stress, so that κ cannot act; what differs between the conditions is the script's expression alone.",
        "It does not show that a stressed voice makes people faster. The paper reports that of its subjects; a program that is told to be faster is.",
        "The voice is a mood that is shown beside the sentences; nothing is spoken aloud, and nobody has judged how it sounds.",
        "Times are compared between the same simulated subjects (the same seed) under each condition; until the first report they do the same in all of them.");
  }
}
