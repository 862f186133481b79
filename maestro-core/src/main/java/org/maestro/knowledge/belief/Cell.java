package org.maestro.knowledge.belief;

import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.knowledge.api.Source;
import org.maestro.sl.Term;

/**
 * The claims on one state variable, and what is believed of it. Claims that stand are kept the best
 * first: a surer one before one that came later, which takes its place when the surer ages or is
 * withdrawn. Those that were overruled are kept to be seen, and do not come back, as the world may
 * have moved on since, unless their source goes on saying so. A cell without claims says that what
 * was known, or described in the home, is lost. Immutable.
 */
public final class Cell {

  static final Cell LOST = new Cell(List.of(), List.of(), Optional.empty());

  private final List<Claim> standing;
  private final List<Claim> overruled;
  private final Optional<Held> last;
  private final Settled settled;

  private Cell(List<Claim> standing, List<Claim> overruled, Optional<Held> last) {
    this.standing = List.copyOf(standing);
    this.overruled = List.copyOf(overruled);
    this.settled = Settled.of(this.standing);
    this.last = settled.value().or(() -> last);
  }

  /** A cell of which nothing is known but what it was once. */
  public static Cell remembered(Held last) {
    return new Cell(List.of(), List.of(), Optional.of(last));
  }

  /** What is believed, however old it is. */
  public Optional<Held> value() {
    return settled.value();
  }

  /** Values that a functional predicate is known not to have, however long ago. */
  Map<Term, Held> excluded() {
    return settled.excluded();
  }

  /** What is believed, however old it is. */
  Settled settled() {
    return settled;
  }

  /** What is believed of what counts at the instant. */
  Settled settled(Predicate<Held> counts) {
    for (Claim claim : standing) {
      if (!counts.test(claim.held())) {
        return Settled.of(standing.stream().filter(c -> counts.test(c.held())).toList());
      }
    }
    return settled;
  }

  /** The best first. */
  List<Claim> standing() {
    return standing;
  }

  /** What the source says of the value, if that stands. */
  Optional<Held> claim(Source source, Term value, boolean has) {
    for (Claim claim : standing) {
      if (claim.has() == has
          && claim.value().equals(value)
          && claim.held().source().equals(source)) {
        return Optional.of(claim.held());
      }
    }
    return Optional.empty();
  }

  /** Claims of other sources that a later one of no less weight contradicts. */
  List<Claim> overruled() {
    return overruled;
  }

  /** The value that was believed last, which may be long ago. */
  Optional<Held> last() {
    return last;
  }

  boolean isLost() {
    return standing.isEmpty();
  }

  /**
   * What has left the place where it was believed to be was moved; so it may be by now where it was
   * not before.
   */
  Cell with(Claim claim, Instant now) {
    List<Claim> stay = new ArrayList<>();
    List<Claim> outdone = new ArrayList<>();
    boolean left = false;
    for (Claim other : standing) {
      if (other.held().isFresh(now)) {
        if (!claim.outdates(other)) {
          stay.add(other);
          continue;
        }
        if (claim.overrules(other)) {
          outdone.add(other);
        }
        left |= !claim.has() && other.has();
      }
    }
    if (left) {
      stay.removeIf(other -> !other.has() && other.held().since().isBefore(claim.held().since()));
    }
    int place = 0;
    while (place < stay.size() && stay.get(place).weight() >= claim.weight()) {
      place++;
    }
    stay.add(place, claim);
    overruled.stream()
        .filter(other -> other.held().isFresh(now))
        .filter(
            other ->
                !claim.held().isExpected() || other.held().source().kind() == Source.Kind.STATED)
        .filter(other -> !other.isOf(claim.held().source().agent()))
        .filter(other -> outdone.stream().noneMatch(o -> isRepeated(o, other)))
        .forEach(outdone::add);
    return new Cell(stay, outdone, last);
  }

  /**
   * Once nobody who counts says anything else, what was overruled counts again where its source
   * goes on saying so: that is no word of the past.
   */
  @SuppressWarnings("ReferenceEquality") // The one that was found, and none that says the same.
  Cell goingOn(Predicate<Claim> stillSaid, Instant now) {
    Settled present = settled(held -> held.isFresh(now));
    if (overruled.isEmpty() || present.value().isPresent()) {
      return this;
    }
    Optional<Claim> again =
        overruled.stream()
            .filter(Claim::has)
            .filter(claim -> claim.held().isFresh(now))
            .filter(claim -> !present.excluded().containsKey(claim.value()))
            .filter(stillSaid)
            .findFirst();
    if (again.isEmpty()) {
      return this;
    }
    List<Claim> stand = new ArrayList<>(standing);
    stand.add(0, again.get());
    return new Cell(stand, overruled.stream().filter(o -> o != again.get()).toList(), last);
  }

  private static boolean isRepeated(Claim newer, Claim older) {
    return newer.isOf(older.held().source().agent());
  }

  /** Only claims for which this holds. */
  Cell only(Predicate<Claim> kept) {
    List<Claim> left = standing.stream().filter(kept).toList();
    List<Claim> seen = overruled.stream().filter(kept).toList();
    return left.size() == standing.size() && seen.size() == overruled.size()
        ? this
        : new Cell(left, seen, last);
  }

  Cell lost() {
    return lostBut(claim -> false);
  }

  /** Lost but for those overruled claims, which may count again if their source says so still. */
  Cell lostBut(Predicate<Claim> kept) {
    return new Cell(List.of(), overruled.stream().filter(kept).toList(), last);
  }

  /** Whether a claim that stands counts at the earlier instant and not at the later one. */
  boolean expiresWithin(Instant earlier, Instant later) {
    for (Claim claim : standing) {
      if (claim.held().isFresh(earlier) && !claim.held().isFresh(later)) {
        return true;
      }
    }
    return false;
  }

  /** The first instant after which something in it does not count any more. */
  Instant nextExpiry() {
    return earliest(standing, earliest(overruled, Instant.MAX));
  }

  private static Instant earliest(Collection<Claim> claims, Instant otherwise) {
    Instant earliest = otherwise;
    for (Claim claim : claims) {
      if (claim.held().expires().isBefore(earliest)) {
        earliest = claim.held().expires();
      }
    }
    return earliest;
  }
}
