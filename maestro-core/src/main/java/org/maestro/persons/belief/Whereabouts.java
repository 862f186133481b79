package org.maestro.persons.belief;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Where persons are, as probabilities over places, and in which zones somebody else is: a forward
 * filter of a hidden Markov model. Persons are believed to move independently of each other (Boyen
 * and Koller 1998): what is noticed of somebody whom nobody knows is shared out among all who can
 * be there, guests included, exactly as far as that goes. Immutable.
 */
public final class Whereabouts {
  private static final double NANOS = 1e9;

  /** No guest is certain: somebody of the home may be where nothing has noticed her go. */
  private static final double MOST_OF_A_GUEST = 0.999;

  private final Movement movement;
  private final double guestShare;
  private final Duration visit;
  private final List<String> persons;
  private final double[][] places;
  private final double[] guests;

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
      double[][] places,
      double[] guests) {
    this.movement = movement;
    this.guestShare = guestShare;
    this.visit = visit;
    this.persons = persons;
    this.places = places;
    this.guests = guests;
  }

  /**
   * Nothing is known: each place is as likely as another.
   *
   * @param guestShare how likely somebody else is in a zone of whom nothing is known, 0 to 1
   * @param visit how long somebody else stays in the home in the mean
   */
  public static Whereabouts unknown(
      List<String> persons, Movement movement, double guestShare, Duration visit) {
    int size = movement.places().size();
    double[][] even = new double[persons.size()][size];
    for (double[] row : even) {
      Arrays.fill(row, 1.0 / size);
    }
    double[] guests = new double[size];
    Arrays.fill(guests, guestShare);
    guests[size - 1] = 0;
    return new Whereabouts(movement, guestShare, visit, List.copyOf(persons), even, guests);
  }

  public List<String> persons() {
    return persons;
  }

  /** How likely the person is in the place. */
  public double probability(String person, String place) {
    return places[number(person)][movement.places().number(place)];
  }

  /** Where the person most likely is; of several the first of the places. */
  public Likely likeliest(String person) {
    double[] row = places[number(person)];
    int best = 0;
    for (int place = 1; place < row.length; place++) {
      if (row[place] > row[best]) {
        best = place;
      }
    }
    return new Likely(movement.places().names().get(best), row[best]);
  }

  /** How likely somebody who is none of the persons is in the zone. */
  public double guest(String zone) {
    return guests[movement.places().number(zone)];
  }

  /** What is to be believed when so much time has passed in which nothing was noticed. */
  public Whereabouts after(Duration time) {
    if (time.isZero() || time.isNegative()) {
      return this;
    }
    double[][] later = new double[places.length][];
    for (int person = 0; person < places.length; person++) {
      later[person] = normalized(movement.after(places[person], time), places[person]);
    }
    double kept = Math.exp(-seconds(time) / seconds(visit));
    double[] others = movement.after(guests, time).clone();
    for (int zone = 0; zone < others.length; zone++) {
      others[zone] = Math.min(MOST_OF_A_GUEST, guestShare + kept * (others[zone] - guestShare));
    }
    others[movement.places().away()] = 0;
    return new Whereabouts(movement, guestShare, visit, persons, later, others);
  }

  /** What is to be believed after this. */
  public Whereabouts given(Evidence evidence) {
    int zone = movement.places().number(evidence.zone());
    return evidence
        .person()
        .map(person -> givenOf(number(person), zone, evidence))
        .orElseGet(() -> givenOfSomebody(zone, evidence));
  }

  private Whereabouts givenOf(int person, int zone, Evidence evidence) {
    double[][] later = places.clone();
    later[person] =
        weighed(places[person], zone, evidence.likelihoodWhereSo(), evidence.likelihoodElsewhere());
    return new Whereabouts(movement, guestShare, visit, persons, later, guests);
  }

  /**
   * It is not said when neither anybody who is there sets it off, nor does it err; each person's
   * likelihood is that over all that the others may do.
   */
  private Whereabouts givenOfSomebody(int zone, Evidence evidence) {
    double silent = 1 - evidence.falseRate();
    double all = silent * unnoticed(guests[zone], evidence);
    for (double[] row : places) {
      all *= unnoticed(row[zone], evidence);
    }
    double[][] later = new double[places.length][];
    for (int person = 0; person < places.length; person++) {
      double without = all / unnoticed(places[person][zone], evidence);
      double silentThere = without * (1 - evidence.hitRate());
      later[person] =
          evidence.said()
              ? weighed(places[person], zone, 1 - silentThere, 1 - without)
              : weighed(places[person], zone, silentThere, without);
    }
    double without = all / unnoticed(guests[zone], evidence);
    double silentThere = without * (1 - evidence.hitRate());
    double so = guests[zone] * (evidence.said() ? 1 - silentThere : silentThere);
    double not = (1 - guests[zone]) * (evidence.said() ? 1 - without : without);
    double[] others = guests.clone();
    others[zone] = so + not > 0 ? Math.min(MOST_OF_A_GUEST, so / (so + not)) : guests[zone];
    return new Whereabouts(movement, guestShare, visit, persons, later, others);
  }

  /** How likely somebody who is there with this probability does not set it off. */
  private static double unnoticed(double probability, Evidence evidence) {
    return 1 - probability * evidence.hitRate();
  }

  private static double[] weighed(double[] row, int zone, double there, double elsewhere) {
    double[] later = new double[row.length];
    for (int place = 0; place < row.length; place++) {
      later[place] = row[place] * (place == zone ? there : elsewhere);
    }
    return normalized(later, row);
  }

  /** What cannot be leaves things as they were. */
  private static double[] normalized(double[] row, double[] otherwise) {
    double sum = Arrays.stream(row).sum();
    if (!(sum > 0)) {
      return otherwise;
    }
    double[] shares = new double[row.length];
    for (int place = 0; place < row.length; place++) {
      shares[place] = row[place] / sum;
    }
    return shares;
  }

  /**
   * The same of other persons, or in other places: who stays and can be where she was is believed
   * to be there as before.
   */
  public Whereabouts of(List<String> others, Movement otherwise) {
    Whereabouts anew = unknown(others, otherwise, guestShare, visit);
    for (String person : others) {
      if (persons.contains(person)) {
        double[] row = anew.places[anew.number(person)];
        Arrays.fill(row, 0);
        for (String place : otherwise.places().names()) {
          if (movement.places().has(place)) {
            row[otherwise.places().number(place)] = probability(person, place);
          }
        }
        double[] even = new double[row.length];
        Arrays.fill(even, 1.0 / row.length);
        anew.places[anew.number(person)] = normalized(row, even);
      }
    }
    return anew;
  }

  /** All probabilities of a person, in the order of the places. */
  public List<Likely> of(String person) {
    List<Likely> all = new ArrayList<>();
    double[] row = places[number(person)];
    for (int place = 0; place < row.length; place++) {
      all.add(new Likely(movement.places().names().get(place), row[place]));
    }
    return all;
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
