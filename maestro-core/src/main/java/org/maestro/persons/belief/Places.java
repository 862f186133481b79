package org.maestro.persons.belief;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiPredicate;

/**
 * The places where a person can be: the zones of a home, and away. One goes only from a zone to
 * those beside it, and away only by the ways out. Immutable.
 */
public final class Places {
  /** The name of being nowhere in the home; no zone has it. */
  public static final String AWAY = "-";

  private final List<String> names;
  private final Map<String, Integer> numbers = new LinkedHashMap<>();
  private final int[][] beside;

  private Places(List<String> names, int[][] beside) {
    this.names = names;
    this.beside = beside;
    names.forEach(name -> numbers.put(name, numbers.size()));
  }

  /**
   * The zones with the ways between them.
   *
   * @param zones none of them named twice, or as {@link #AWAY} is
   * @param isWay whether one goes straight from one to the other, or back
   * @param waysOut from which one leaves the home, some of the zones; none: any
   */
  public static Places of(
      List<String> zones, BiPredicate<String, String> isWay, Set<String> waysOut) {
    List<String> names = new ArrayList<>(zones);
    names.add(AWAY);
    int away = zones.size();
    List<Set<Integer>> ways = names.stream().<Set<Integer>>map(n -> new LinkedHashSet<>()).toList();
    for (int a = 0; a < away; a++) {
      for (int b = a + 1; b < away; b++) {
        if (isWay.test(names.get(a), names.get(b)) || isWay.test(names.get(b), names.get(a))) {
          ways.get(a).add(b);
          ways.get(b).add(a);
        }
      }
      if (waysOut.isEmpty() || waysOut.contains(names.get(a))) {
        ways.get(a).add(away);
        ways.get(away).add(a);
      }
    }
    return new Places(
        List.copyOf(names),
        ways.stream()
            .map(all -> all.stream().mapToInt(Integer::intValue).toArray())
            .toArray(int[][]::new));
  }

  /** All of them, away last. */
  public List<String> names() {
    return names;
  }

  /** How many places are beside it, away included. */
  public int waysFrom(String place) {
    return beside[number(place)].length;
  }

  /** Whether it is one of them. */
  public boolean has(String place) {
    return numbers.containsKey(place);
  }

  /** Whether one goes from one straight to the other. */
  public boolean areBeside(String one, String other) {
    int wanted = number(other);
    for (int next : beside[number(one)]) {
      if (next == wanted) {
        return true;
      }
    }
    return false;
  }

  /** Whether they are the same places with the same ways between them. */
  public boolean areThoseOf(Places other) {
    return names.equals(other.names) && Arrays.deepEquals(beside, other.beside);
  }

  int size() {
    return names.size();
  }

  int away() {
    return names.size() - 1;
  }

  int number(String place) {
    Integer number = numbers.get(place);
    if (number == null) {
      throw new IllegalArgumentException("There is no place " + place + "; there are " + names);
    }
    return number;
  }

  int[] beside(int place) {
    return beside[place];
  }
}
