package org.maestro.persons.belief;

import java.util.Arrays;
import java.util.function.IntToDoubleFunction;

/**
 * Where some persons are together: a probability for each way in which they can be spread over the
 * places, so that of two who may be where something was noticed one is enough. Immutable.
 */
final class JointBelief {
  private final int persons;
  private final int places;
  private final double[] shares;

  private JointBelief(int persons, int places, double[] shares) {
    this.persons = persons;
    this.places = places;
    this.shares = shares;
  }

  /**
   * Persons of whom nothing ties one to another.
   *
   * @param each probabilities over the places, a row for each person, at least one
   */
  static JointBelief independent(double[][] each) {
    int places = each[0].length;
    double[] shares = {1};
    for (double[] row : each) {
      double[] more = new double[shares.length * places];
      for (int spread = 0; spread < shares.length; spread++) {
        for (int place = 0; place < places; place++) {
          more[spread * places + place] = shares[spread] * row[place];
        }
      }
      shares = more;
    }
    return new JointBelief(each.length, places, shares);
  }

  /** Places lie so far apart in the shares, of this person. */
  private int stride(int person) {
    int stride = 1;
    for (int later = person + 1; later < persons; later++) {
      stride *= places;
    }
    return stride;
  }

  /** Where one of them is, whatever the others do. */
  double[] of(int person) {
    int stride = stride(person);
    double[] row = new double[places];
    for (int spread = 0; spread < shares.length; spread++) {
      row[spread / stride % places] += shares[spread];
    }
    return row;
  }

  /**
   * After each has gone on by herself.
   *
   * @param chances by person, from and to: how likely she has gone there from there
   */
  JointBelief moved(double[][][] chances) {
    double[] now = shares;
    for (int person = 0; person < persons; person++) {
      now = moved(now, stride(person), chances[person]);
    }
    return normalized(now);
  }

  private double[] moved(double[] before, int stride, double[][] chances) {
    double[] after = new double[before.length];
    for (int spread = 0; spread < before.length; spread++) {
      if (before[spread] > 0) {
        int from = spread / stride % places;
        int first = spread - from * stride;
        double[] to = chances[from];
        for (int place = 0; place < places; place++) {
          after[first + place * stride] += before[spread] * to[place];
        }
      }
    }
    return after;
  }

  /** After something that is so likely where the person is there, and so likely elsewhere. */
  JointBelief weighed(int person, int zone, double there, double elsewhere) {
    int stride = stride(person);
    double[] weighed = new double[shares.length];
    for (int spread = 0; spread < shares.length; spread++) {
      weighed[spread] = shares[spread] * (spread / stride % places == zone ? there : elsewhere);
    }
    return normalized(weighed);
  }

  /** After something that is as likely as the number of persons makes it who are in the zone. */
  JointBelief weighed(int zone, IntToDoubleFunction likelihood) {
    double[] byNumber = new double[persons + 1];
    Arrays.setAll(byNumber, likelihood);
    double[] weighed = new double[shares.length];
    for (int spread = 0; spread < shares.length; spread++) {
      weighed[spread] = shares[spread] * byNumber[numberIn(zone, spread)];
    }
    return normalized(weighed);
  }

  /** The mean of what the number of persons makes it who are in the zone. */
  double mean(int zone, IntToDoubleFunction value) {
    double mean = 0;
    for (int spread = 0; spread < shares.length; spread++) {
      mean += shares[spread] * value.applyAsDouble(numberIn(zone, spread));
    }
    return mean;
  }

  private int numberIn(int zone, int spread) {
    int number = 0;
    int left = spread;
    for (int person = 0; person < persons; person++) {
      number += left % places == zone ? 1 : 0;
      left /= places;
    }
    return number;
  }

  /** What cannot be leaves things as they were. */
  private JointBelief normalized(double[] other) {
    double sum = Arrays.stream(other).sum();
    if (!(sum > 0)) {
      return this;
    }
    for (int spread = 0; spread < other.length; spread++) {
      other[spread] /= sum;
    }
    return new JointBelief(persons, places, other);
  }
}
