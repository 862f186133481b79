package org.maestro.experiment;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.maestro.experiment.EveningRun.Wanted;
import org.maestro.experiment.measuring.Difference;
import org.maestro.experiment.measuring.Interval;
import org.maestro.experiment.measuring.Share;
import org.maestro.experiment.measuring.Spread;

/**
 * The same evenings in each of the homes, run by run with the same seed, and what of their
 * differences is shown.
 */
final class Compared {
  private final Comparison comparison;
  private final List<List<EveningRun>> evenings;

  /**
   * @param evenings for each run one of each home, in the order of the homes
   */
  Compared(Comparison comparison, List<List<EveningRun>> evenings) {
    this.comparison = comparison;
    this.evenings = evenings;
  }

  List<String> names() {
    return comparison.setUps().stream().map(Comparison.SetUp::name).toList();
  }

  List<Wish> wishes() {
    return comparison.wishes();
  }

  int runs() {
    return evenings.size();
  }

  /** All evenings of a home. */
  List<EveningRun> of(int home) {
    return evenings.stream().map(all -> all.get(home)).toList();
  }

  List<Measure> measures() {
    List<Measure> measures = new ArrayList<>();
    measures.add(counted(Measure.Kind.ALL_REACHED, List.of()));
    for (int wish = 0; wish < wishes().size(); wish++) {
      measures.add(reached(wish));
      measures.add(time(wish));
    }
    measures.add(mean(Measure.Kind.EVENING, "", EveningRun::seconds, true));
    measures.add(mean(Measure.Kind.ENERGY, "", EveningRun::wattHours, true));
    for (String zone : commonZones()) {
      measures.add(
          mean(Measure.Kind.LIGHT, zone, run -> run.lux().getOrDefault(zone, Double.NaN), false));
    }
    measures.add(counted(Measure.Kind.FALSELY_CLAIMED, List.of(EveningRun.End.FALSELY_CLAIMED)));
    return List.copyOf(measures);
  }

  /** What is shown, a sentence each. */
  List<String> claims() {
    List<String> claims = new ArrayList<>();
    for (int home = 1; home < names().size(); home++) {
      for (Measure measure : measures()) {
        measure.claim(home, names().get(home), names().get(0)).ifPresent(claims::add);
      }
    }
    if (claims.isEmpty()) {
      claims.add(
          runs() < 2
              ? "Nothing is claimed: one run shows no difference."
              : "Nothing is claimed: there is no difference of which the interval leaves out 0.");
    }
    return List.copyOf(claims);
  }

  /**
   * What could not be done in a home, and in how many runs for that reason.
   *
   * @param why in the platform's words
   */
  record Undone(String home, String goal, int runs, String why) {
    String sentence() {
      return "%s, %s, not reached in %d run%s: %s"
          .formatted(home, goal, runs, runs == 1 ? "" : "s", why);
    }
  }

  List<Undone> undone() {
    List<Undone> undone = new ArrayList<>();
    for (int home = 0; home < names().size(); home++) {
      for (int wish = 0; wish < wishes().size(); wish++) {
        List<String> reasons =
            wanted(home, wish).stream()
                .filter(one -> !one.isReached())
                .map(Wanted::failure)
                .toList();
        for (String why : reasons.stream().distinct().toList()) {
          int runs = (int) reasons.stream().filter(why::equals).count();
          undone.add(new Undone(names().get(home), wishes().get(wish).goal(), runs, why));
        }
      }
    }
    return List.copyOf(undone);
  }

  private List<Wanted> wanted(int home, int wish) {
    return of(home).stream().map(run -> run.wanted().get(wish)).toList();
  }

  private Set<String> commonZones() {
    Set<String> zones = new TreeSet<>(of(0).get(0).lux().keySet());
    IntStream.range(1, names().size())
        .forEach(home -> zones.retainAll(of(home).get(0).lux().keySet()));
    return zones;
  }

  /**
   * Of all goals together, which are not independent of each other: no interval is told.
   *
   * @param ends that count; none: those that were reached
   */
  private Measure counted(Measure.Kind kind, List<EveningRun.End> ends) {
    List<Double> values = new ArrayList<>();
    List<String> cells = new ArrayList<>();
    for (int home = 0; home < names().size(); home++) {
      long count =
          of(home).stream()
              .flatMap(run -> run.wanted().stream())
              .filter(one -> ends.isEmpty() ? one.isReached() : ends.contains(one.end()))
              .count();
      values.add((double) count);
      cells.add("%d of %d".formatted(count, runs() * wishes().size()));
    }
    return new Measure(kind, "", values, cells, List.of());
  }

  private Measure reached(int wish) {
    List<Share> shares =
        IntStream.range(0, names().size())
            .mapToObj(
                home ->
                    new Share(
                        (int) wanted(home, wish).stream().filter(Wanted::isReached).count(),
                        runs()))
            .toList();
    return new Measure(
        Measure.Kind.REACHED,
        wishes().get(wish).goal(),
        shares.stream().map(Share::value).toList(),
        shares.stream().map(share -> "%d of %d".formatted(share.hits(), share.of())).toList(),
        shares.stream().skip(1).map(share -> Difference.ofShares(shares.get(0), share)).toList());
  }

  /** Compared run by run, where both have reached it. */
  private Measure time(int wish) {
    List<Double> means = new ArrayList<>();
    List<Difference> differences = new ArrayList<>();
    for (int home = 0; home < names().size(); home++) {
      means.add(
          Spread.of(
                  wanted(home, wish).stream()
                      .filter(Wanted::isReached)
                      .mapToDouble(Wanted::seconds)
                      .toArray())
              .mean());
      if (home > 0) {
        List<Wanted> first = wanted(0, wish);
        List<Wanted> other = wanted(home, wish);
        List<Integer> both =
            IntStream.range(0, runs())
                .filter(run -> first.get(run).isReached() && other.get(run).isReached())
                .boxed()
                .toList();
        differences.add(
            Difference.ofPairs(
                both.stream().map(run -> first.get(run).seconds()).toList(),
                both.stream().map(run -> other.get(run).seconds()).toList()));
      }
    }
    return told(Measure.Kind.TIME, wishes().get(wish).goal(), means, differences);
  }

  /**
   * @param alike whether only such runs are compared in which the same goals were reached: who
   *     gives up is soon done, and saves light
   */
  private Measure mean(
      Measure.Kind kind, String of, ToDoubleFunction<EveningRun> figure, boolean alike) {
    List<Double> means = new ArrayList<>();
    List<Difference> differences = new ArrayList<>();
    for (int home = 0; home < names().size(); home++) {
      means.add(Spread.of(of(home).stream().mapToDouble(figure).toArray()).mean());
      if (home > 0) {
        int other = home;
        List<List<EveningRun>> pairs =
            evenings.stream()
                .filter(all -> !alike || isReachedAlike(all.get(0), all.get(other)))
                .toList();
        differences.add(
            Difference.ofPairs(
                pairs.stream().map(all -> figure.applyAsDouble(all.get(0))).toList(),
                pairs.stream().map(all -> figure.applyAsDouble(all.get(other))).toList()));
      }
    }
    return told(kind, of, means, differences);
  }

  private static boolean isReachedAlike(EveningRun one, EveningRun other) {
    return one.wanted().stream()
        .map(Wanted::isReached)
        .toList()
        .equals(other.wanted().stream().map(Wanted::isReached).toList());
  }

  private static Measure told(
      Measure.Kind kind, String of, List<Double> means, List<Difference> differences) {
    return new Measure(kind, of, means, means.stream().map(kind::text).toList(), differences);
  }

  /** The numbers of the differences, for documents. */
  List<Findings.Result> results() {
    List<Findings.Result> results = new ArrayList<>();
    for (Measure measure : measures()) {
      for (int home = 0; home < names().size(); home++) {
        results.add(
            result(
                names().get(home) + ": " + measure.label(), measure, measure.values().get(home)));
      }
      for (int home = 1; home <= measure.differences().size(); home++) {
        Difference difference = measure.differences().get(home - 1);
        Interval interval = difference.interval();
        String name =
            "%s more than %s: %s".formatted(names().get(home), names().get(0), measure.label());
        results.add(result(name, measure, difference.value()));
        results.add(result(name + ", at least", measure, interval.least()));
        results.add(result(name + ", at most", measure, interval.greatest()));
      }
    }
    return List.copyOf(results);
  }

  private static Findings.Result result(String name, Measure measure, double value) {
    boolean isShare = measure.what() == Measure.Kind.REACHED;
    return new Findings.Result(name, value, isShare ? "" : measure.what().unit());
  }
}
