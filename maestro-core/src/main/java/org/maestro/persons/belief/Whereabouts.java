package org.maestro.persons.belief;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;

/**
 * Where persons are, as probabilities over places: a forward filter of a hidden Markov model.
 * Beside them there may be one guest, whom nobody knows. They move independently of each other;
 * what was noticed of somebody without a name ties them together, and is reckoned with exactly for
 * as many as fit into {@value #MOST_SPREADS} ways of being spread over the places. Larger
 * households are followed in groups, between which only that much is known (Boyen and Koller 1998).
 * Immutable.
 */
public final class Whereabouts {
  /** Five persons and a guest in eight places. */
  private static final int MOST_SPREADS = 300_000;

  private static final double NANOS = 1e9;

  private final Movement movement;
  private final double guestShare;
  private final Duration visit;
  private final List<String> persons;

  /** In the first of them the guest is the last. */
  private final List<JointBelief> groups;

  /** How many of the persons are in each group, but for the last, where it may be fewer. */
  private final int size;

  /** A place with its probability. */
  public record Likely(String place, double probability) {
    public boolean isAway() {
      return place.equals(Places.AWAY);
    }
  }

  private Whereabouts(
      Movement movement,
      double guestShare,
      Duration visit,
      List<String> persons,
      List<JointBelief> groups) {
    this.movement = movement;
    this.guestShare = guestShare;
    this.visit = visit;
    this.persons = persons;
    this.groups = List.copyOf(groups);
    this.size = size(movement.places());
  }

  private static int size(Places places) {
    int size = 1;
    while (Math.pow(places.size(), size + 2) <= MOST_SPREADS) {
      size++;
    }
    return size;
  }

  /**
   * Nothing is known: each place is as likely as another.
   *
   * @param guestShare how likely a guest is in a zone of which nothing is known, 0 to 1 in all
   *     zones together
   * @param visit how long a guest stays in the home in the mean
   */
  public static Whereabouts unknown(
      List<String> persons, Movement movement, double guestShare, Duration visit) {
    double[] even = new double[movement.places().size()];
    Arrays.fill(even, 1.0 / even.length);
    return of(persons, persons.stream().map(p -> even).toList(), movement, guestShare, visit);
  }

  private static Whereabouts of(
      List<String> persons,
      List<double[]> each,
      Movement movement,
      double guestShare,
      Duration visit) {
    int size = size(movement.places());
    List<JointBelief> groups = new ArrayList<>();
    for (int first = 0; first == 0 || first < persons.size(); first += size) {
      List<double[]> rows =
          new ArrayList<>(each.subList(first, Math.min(persons.size(), first + size)));
      if (first == 0) {
        rows.add(strangers(movement.places(), guestShare));
      }
      groups.add(JointBelief.independent(rows.toArray(double[][]::new)));
    }
    return new Whereabouts(movement, guestShare, visit, List.copyOf(persons), groups);
  }

  /** Where a guest is of whom nothing is known. */
  private static double[] strangers(Places places, double guestShare) {
    double[] row = new double[places.size()];
    double share = Math.min(guestShare, 1.0 / row.length);
    Arrays.fill(row, share);
    row[places.away()] = 1 - share * places.away();
    return row;
  }

  public List<String> persons() {
    return persons;
  }

  /** How likely the person is in the place. */
  public double probability(String person, String place) {
    return row(person)[movement.places().number(place)];
  }

  /** Where the person most likely is; of several the first of the places. */
  public Likely likeliest(String person) {
    double[] row = row(person);
    int best = 0;
    for (int place = 1; place < row.length; place++) {
      if (row[place] > row[best]) {
        best = place;
      }
    }
    return new Likely(movement.places().names().get(best), row[best]);
  }

  /** All probabilities of a person, in the order of the places. */
  public List<Likely> of(String person) {
    double[] row = row(person);
    return IntStream.range(0, row.length)
        .mapToObj(place -> new Likely(movement.places().names().get(place), row[place]))
        .toList();
  }

  private double[] row(String person) {
    int number = number(person);
    return groups.get(number / size).of(number % size);
  }

  /** How likely somebody who is none of the persons is in the zone. */
  public double guest(String zone) {
    return groups.get(0).of(members(0))[movement.places().number(zone)];
  }

  /** How many of the persons are in a group. */
  private int members(int group) {
    return Math.min(persons.size() - group * size, size);
  }

  /** What is to be believed when so much time has passed in which nothing was noticed. */
  public Whereabouts after(Duration time) {
    if (time.isZero() || time.isNegative()) {
      return this;
    }
    double[][] own = movement.chances(time);
    double[][] ofGuest = ofGuest(own, time);
    List<JointBelief> later = new ArrayList<>();
    for (int group = 0; group < groups.size(); group++) {
      double[][][] chances = new double[members(group) + (group == 0 ? 1 : 0)][][];
      Arrays.fill(chances, own);
      if (group == 0) {
        chances[chances.length - 1] = ofGuest;
      }
      later.add(groups.get(group).moved(chances));
    }
    return with(later);
  }

  /** Visits end, and others begin: then nothing is known of where the guest is. */
  private double[][] ofGuest(double[][] own, Duration time) {
    double kept = Math.exp(-seconds(time) / seconds(visit));
    double[] anew = strangers(movement.places(), guestShare);
    double[][] chances = new double[own.length][own.length];
    for (int from = 0; from < own.length; from++) {
      for (int to = 0; to < own.length; to++) {
        double stays = from == movement.places().away() ? from == to ? 1 : 0 : own[from][to];
        chances[from][to] = kept * stays + (1 - kept) * anew[to];
      }
    }
    return chances;
  }

  /** What is to be believed after this. */
  public Whereabouts given(Evidence evidence) {
    int zone = movement.places().number(evidence.zone());
    Optional<String> person = evidence.person();
    return person.isPresent()
        ? givenOf(number(person.get()), zone, evidence)
        : givenOfSomebody(zone, evidence);
  }

  private Whereabouts givenOf(int person, int zone, Evidence evidence) {
    List<JointBelief> later = new ArrayList<>(groups);
    later.set(
        person / size,
        groups
            .get(person / size)
            .weighed(
                person % size, zone, evidence.likelihoodWhereSo(), evidence.likelihoodElsewhere()));
    return with(later);
  }

  /** It is not said when neither anybody who is there sets it off, nor does it err. */
  private Whereabouts givenOfSomebody(int zone, Evidence evidence) {
    IntToDoubleFunction unnoticed = number -> Math.pow(1 - evidence.hitRate(), number);
    double[] silent = new double[groups.size()];
    double all = 1 - evidence.falseRate();
    for (int group = 0; group < silent.length; group++) {
      silent[group] = groups.get(group).mean(zone, unnoticed);
      all *= silent[group];
    }
    List<JointBelief> later = new ArrayList<>();
    for (int group = 0; group < silent.length; group++) {
      double others = all / silent[group];
      later.add(
          groups
              .get(group)
              .weighed(
                  zone,
                  number ->
                      evidence.said()
                          ? 1 - others * unnoticed.applyAsDouble(number)
                          : unnoticed.applyAsDouble(number)));
    }
    return with(later);
  }

  private Whereabouts with(List<JointBelief> others) {
    return new Whereabouts(movement, guestShare, visit, persons, others);
  }

  /**
   * The same of other persons, or in other places: who stays and can be where she was is believed
   * to be there as before.
   */
  public Whereabouts of(List<String> others, Movement otherwise) {
    List<double[]> each = new ArrayList<>();
    for (String person : others) {
      double[] row = new double[otherwise.places().size()];
      if (persons.contains(person)) {
        otherwise.places().names().stream()
            .filter(movement.places()::has)
            .forEach(place -> row[otherwise.places().number(place)] = probability(person, place));
      }
      double sum = Arrays.stream(row).sum();
      Arrays.setAll(row, place -> sum > 0 ? row[place] / sum : 1.0 / row.length);
      each.add(row);
    }
    return of(others, each, otherwise, guestShare, visit);
  }

  private int number(String person) {
    int number = persons.indexOf(person);
    if (number < 0) {
      throw new IllegalArgumentException("There is no person " + person + "; there are " + persons);
    }
    return number;
  }

  private static double seconds(Duration time) {
    return time.getSeconds() + time.getNano() / NANOS;
  }
}
