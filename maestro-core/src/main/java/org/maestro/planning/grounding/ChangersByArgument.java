package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.IntFunction;
import org.maestro.sl.Term;

/**
 * Of the features that may change one predicate or number those that may change it of given
 * arguments: in a building a lamp is asked for the zones that it shines upon, and not for each.
 */
final class ChangersByArgument {
  private final IntFunction<List<Optional<Set<Term>>>> reachOf;

  /** For a feature's number the values that each argument can have, as far as that is told. */
  private final Map<Integer, List<Optional<Set<Term>>>> reach = new HashMap<>();

  private final List<Place> places = new ArrayList<>();

  /** The features that may change what has a value at one place of the arguments. */
  private record Place(Map<Term, List<Integer>> byValue, List<Integer> ofAny) {
    List<Integer> of(Term value) {
      return byValue.getOrDefault(value, List.of());
    }

    int count(Term value) {
      return of(value).size() + ofAny.size();
    }
  }

  /**
   * @param reachOf for a feature's number the values that each argument can have where it changes
   *     something; empty for one of which that is not told
   */
  ChangersByArgument(IntFunction<List<Optional<Set<Term>>>> reachOf) {
    this.reachOf = reachOf;
  }

  /**
   * Numbers of the features that may, some that went perhaps among them, in no order.
   *
   * @param features all that there are now
   */
  List<Integer> of(List<Integer> features, List<Term> arguments) {
    features.stream().filter(number -> !reach.containsKey(number)).forEach(this::add);
    List<Integer> fewest = features;
    for (int i = 0; i < Math.min(places.size(), arguments.size()); i++) {
      Place place = places.get(i);
      Term value = arguments.get(i);
      if (place.count(value) < fewest.size()) {
        fewest = new ArrayList<>(place.of(value));
        fewest.addAll(place.ofAny());
      }
    }
    return fewest.stream().filter(number -> mayChange(number, arguments)).toList();
  }

  private boolean mayChange(int number, List<Term> arguments) {
    List<Optional<Set<Term>>> own = Objects.requireNonNull(reach.get(number));
    for (int i = 0; i < Math.min(own.size(), arguments.size()); i++) {
      Term value = arguments.get(i);
      if (own.get(i).filter(values -> !values.contains(value)).isPresent()) {
        return false;
      }
    }
    return true;
  }

  private void add(int number) {
    List<Optional<Set<Term>>> own = reachOf.apply(number);
    while (places.size() < own.size()) {
      // Of those that came before nothing is told of this place.
      places.add(new Place(new HashMap<>(), new ArrayList<>(reach.keySet())));
    }
    reach.put(number, own);
    for (int i = 0; i < places.size(); i++) {
      Place place = places.get(i);
      Optional<Set<Term>> values = i < own.size() ? own.get(i) : Optional.empty();
      values.ifPresentOrElse(
          some ->
              some.forEach(
                  value ->
                      place.byValue().computeIfAbsent(value, v -> new ArrayList<>()).add(number)),
          () -> place.ofAny().add(number));
    }
  }
}
