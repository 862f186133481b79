package org.maestro.planning.api;

import java.util.List;
import org.maestro.sl.Term;

/**
 * A search within a plan for something that nobody knows: where the plan looks, and what else it
 * could have looked into first.
 *
 * @param predicate the functional predicate whose value is sought, such as {@code in}
 * @param arguments its arguments without the value: the thing
 * @param places all that are not excluded: the one that is chosen, then by what it is expected to
 *     cost to begin there, last those into which nobody can look
 */
public record PlannedSearch(String predicate, List<Term> arguments, List<Place> places) {
  /** Up to so many places it is weighed how each look changes the cost of each other one. */
  public static final int MANY_PLACES = 8;

  public PlannedSearch {
    arguments = List.copyOf(arguments);
    places = List.copyOf(places);
  }

  /**
   * One place to begin with.
   *
   * @param chance that it is there, 0 to 1; of all places they sum up to 1
   * @param lookCost of all that has to be done for the look, and the look; cost units, infinite
   *     where nobody can look
   * @param expectedCost of reaching the goal when the search begins here; cost units
   */
  public record Place(Term value, double chance, double lookCost, double expectedCost) {}

  /**
   * A look that costs more than this is not the best first one, by chance over cost, even where it
   * is of use for the likeliest place into which nobody can look as yet.
   */
  public double dearestUsefulLook() {
    Place first = places.get(0);
    double likeliest =
        places.stream()
            .filter(place -> Double.isInfinite(place.lookCost()))
            .mapToDouble(Place::chance)
            .max()
            .orElse(0);
    return first.chance() > 0
        ? first.lookCost() * likeliest / first.chance()
        : Double.POSITIVE_INFINITY;
  }
}
