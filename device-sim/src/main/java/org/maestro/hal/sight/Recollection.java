package org.maestro.hal.sight;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.maestro.hal.Position;

/**
 * The places at which the cameras of a site have last seen what looks alike, by which it is told
 * which of them is seen now. One thread.
 */
public final class Recollection {

  /** Nearer than this it is the same place. */
  private static final double SAME_METRES = 0.15;

  private final Map<String, Position> places;

  /**
   * @param places that are known from the start, as of things that somebody has shown
   */
  public Recollection(Map<String, Position> places) {
    this.places = new TreeMap<>(places);
  }

  /** Where it was seen last, as far as that place was not seen empty since. */
  public Optional<Position> place(String name) {
    return Optional.ofNullable(places.get(name));
  }

  /**
   * What a look comes to.
   *
   * @param place where the wanted thing is; empty when it is not seen
   * @param doubt why it cannot be said which of those that are seen it is; one sentence
   */
  public record Verdict(Optional<Position> place, Optional<String> doubt) {
    private static Verdict at(Position place) {
      return new Verdict(Optional.of(place), Optional.empty());
    }
  }

  /**
   * Tells the wanted thing among those that look like it.
   *
   * @param alike names of all others that look like it
   * @param seen places where something that looks like it is seen
   * @param inView whether the floor of a place is in view, so that what stood there would be seen
   */
  public Verdict judge(
      String wanted, Set<String> alike, List<Position> seen, Predicate<Position> inView) {
    forgetWhatIsGone(wanted, alike, seen, inView);
    Optional<Position> own = near(places.get(wanted), seen);
    if (own.isPresent()) {
      return remembered(wanted, own.get());
    }
    List<Position> others = new ArrayList<>(seen);
    List<String> unknown = new ArrayList<>();
    // where it should be nobody looks: what is seen here may as well be another that was moved
    boolean isElsewhere = places.containsKey(wanted);
    for (String name : alike) {
      Optional<Position> seenHere = near(places.get(name), others);
      seenHere.ifPresent(others::remove);
      if (seenHere.isEmpty() && (isElsewhere || !places.containsKey(name))) {
        unknown.add(name);
      }
    }
    if (others.isEmpty()) {
      return new Verdict(Optional.empty(), Optional.empty());
    }
    if (others.size() == 1 && unknown.isEmpty()) {
      return remembered(wanted, others.get(0));
    }
    return new Verdict(Optional.empty(), Optional.of(doubt(wanted, others, unknown)));
  }

  private static String doubt(String wanted, List<Position> seen, List<String> unknown) {
    return unknown.isEmpty()
        ? "%d things in view look like %s, and neither their size nor their place tells which it is."
            .formatted(seen.size(), wanted)
        : "What is in view may be %s as well as %s: they look alike, and it is not known where %s now."
            .formatted(
                wanted,
                String.join(" or ", unknown),
                unknown.size() == 1 ? "the other is" : "the others are");
  }

  private Verdict remembered(String wanted, Position place) {
    places.put(wanted, place);
    return Verdict.at(place);
  }

  private void forgetWhatIsGone(
      String wanted, Set<String> alike, List<Position> seen, Predicate<Position> inView) {
    places
        .entrySet()
        .removeIf(
            entry ->
                (entry.getKey().equals(wanted) || alike.contains(entry.getKey()))
                    && near(entry.getValue(), seen).isEmpty()
                    && inView.test(entry.getValue()));
  }

  private static Optional<Position> near(@Nullable Position place, List<Position> seen) {
    return place == null
        ? Optional.empty()
        : seen.stream()
            .filter(other -> away(other, place) <= SAME_METRES)
            .min((one, other) -> Double.compare(away(one, place), away(other, place)));
  }

  private static double away(Position one, Position other) {
    return one.floor().distance(other.floor());
  }
}
