package org.maestro.launch;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.coordination.api.Sentences;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.Step;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** What planning for a home's goal came to, in sentences. */
record HomePlanText(Sentences sentences, PrintWriter out) {
  /** Told of a search, beside the one where it begins. */
  private static final int MOST_PLACES = 3;

  /**
   * @param told words for want of which there is no plan from the file alone
   */
  void print(PlanningResult result, Set<String> told) {
    if (result instanceof PlanningResult.Found found) {
      for (Step step : found.plan().steps()) {
        out.printf(
            Locale.ROOT,
            "%3d. %s; %s%s%n",
            step.number(),
            sentences.step(step),
            step.exactPrice() ? "" : "at least ",
            Sentences.number(step.cost()));
      }
      found.plan().searches().forEach(search -> printSearch(search));
      out.printf("; cost = %s (%s)%n", Sentences.number(found.plan().cost()), worth(found));
    } else if (result instanceof PlanningResult.Impossible impossible) {
      out.println(
          told.isEmpty()
              ? "; unsolvable (proven)"
              : "; no plan from the file alone: the devices themselves tell "
                  + String.join(", ", told));
      impossible
          .explanation()
          .obstacles()
          .forEach(
              obstacle ->
                  out.printf(
                      "; needed: %s, %s; %s: %s%n",
                      obstacle.condition(),
                      obstacle.needed(),
                      reachedWord(obstacle),
                      obstacle.possible()));
    } else if (result instanceof PlanningResult.GaveUp gaveUp) {
      out.println("; no plan found: " + gaveUp.reason());
    }
  }

  /** Where it is looked first, how surely it is there, and what else was weighed. */
  private void printSearch(PlannedSearch search) {
    PlannedSearch.Place first = search.places().get(0);
    List<Term> found = new ArrayList<>(search.arguments());
    found.add(first.value());
    out.printf(
        Locale.ROOT,
        "; %s: %.0f %%; to look there first is expected to cost %s in all%s%n",
        sentences.fact(new Formula.Atom(search.predicate(), found)),
        100 * first.chance(),
        Sentences.number(first.expectedCost()),
        search.places().stream()
            .skip(1)
            .filter(place -> Double.isFinite(place.expectedCost()))
            .limit(MOST_PLACES)
            .map(
                place ->
                    ", in %s %s"
                        .formatted(
                            SlPrinter.print(place.value()), Sentences.number(place.expectedCost())))
            .collect(Collectors.joining()));
  }

  /** What is said of the cost: no more than is proven. */
  private static String worth(PlanningResult.Found found) {
    if (found.atLeast().isPresent()) {
      return "lower bound " + Sentences.number(found.atLeast().getAsDouble());
    }
    return HomePlan.findsOut(found) ? "if what is found out is as hoped" : "optimal";
  }

  /** What is only known now, or the best that was found, is no limit. */
  private static String reachedWord(PlanningResult.Obstacle obstacle) {
    if (obstacle.kind() != PlanningResult.Obstacle.Kind.NUMBER) {
      return "possible";
    }
    return switch (obstacle.extent()) {
      case KNOWN -> "it is";
      case LIMIT, LIMIT_NOW -> "possible";
      case FOUND -> "found";
    };
  }
}
