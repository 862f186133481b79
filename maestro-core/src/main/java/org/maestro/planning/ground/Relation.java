package org.maestro.planning.ground;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** The tuples of one predicate that may hold, found by any of their objects. */
final class Relation {
  private static final int[] NONE = {};

  /** Odd, so that no two keys become the same. */
  private static final long SPREAD = 0x9E3779B97F4A7C15L;

  /** A growing list of tuple numbers. */
  private static final class Bucket {
    private int[] numbers = new int[4];
    private int size;

    private void add(int number) {
      if (size == numbers.length) {
        numbers = Arrays.copyOf(numbers, 2 * size);
      }
      numbers[size++] = number;
    }
  }

  /** An object array with a hash, as a key. */
  private record Key(int[] objects, int hash) {
    private static Key of(int[] objects) {
      return new Key(objects, Arrays.hashCode(objects));
    }

    @Override
    public boolean equals(Object other) {
      return other instanceof Key that && Arrays.equals(objects, that.objects);
    }

    @Override
    public int hashCode() {
      return hash;
    }
  }

  private final int bits;
  private final List<int[]> tuples = new ArrayList<>();
  private final Map<Key, Integer> numbers = new HashMap<>();
  private final Map<Integer, Map<Long, Bucket>> indexes = new HashMap<>();
  private final Bucket all = new Bucket();

  /**
   * @param objects how many there are
   */
  Relation(int objects) {
    bits = 64 - Long.numberOfLeadingZeros(objects + 1L);
  }

  int size() {
    return tuples.size();
  }

  int[] tuple(int number) {
    return tuples.get(number);
  }

  /** The tuple's number, or -1. */
  int number(int[] tuple) {
    return numbers.getOrDefault(Key.of(tuple), -1);
  }

  /** Adds a new tuple. */
  int add(int[] tuple) {
    int number = tuples.size();
    tuples.add(tuple);
    numbers.put(Key.of(tuple), number);
    all.add(number);
    indexes.forEach(
        (mask, index) ->
            index.computeIfAbsent(key(mask, tuple), absent -> new Bucket()).add(number));
    return number;
  }

  /** Unlike for unlike objects, and spread: the low bits alone would fall together in a table. */
  private long key(int mask, int[] tuple) {
    long key = 0;
    for (int i = 0; i < tuple.length; i++) {
      if ((mask >> i & 1) != 0) {
        key = key << bits | tuple[i];
      }
    }
    return key * SPREAD;
  }

  /** As many positions as fit into a key; the others have to be compared. */
  private int fitting(int mask) {
    int most = 63 / bits;
    int fitting = 0;
    for (int i = 0, taken = 0; i < 31 && taken < most; i++) {
      if ((mask >> i & 1) != 0) {
        fitting |= 1 << i;
        taken++;
      }
    }
    return fitting;
  }

  /** Tuples that agree with the pattern, in which what is below 0 is open, and perhaps more. */
  Matches matching(int[] pattern) {
    int mask = 0;
    for (int i = 0; i < pattern.length; i++) {
      if (pattern[i] >= 0) {
        mask |= 1 << i;
      }
    }
    if (mask == 0) {
      return new Matches(all.numbers, all.size);
    }
    int used = fitting(mask);
    Map<Long, Bucket> index = indexes.get(used);
    if (index == null) {
      index = new HashMap<>();
      for (int number = 0; number < tuples.size(); number++) {
        index.computeIfAbsent(key(used, tuples.get(number)), absent -> new Bucket()).add(number);
      }
      indexes.put(used, index);
    }
    Bucket bucket = index.get(key(used, pattern));
    return bucket == null ? new Matches(NONE, 0) : new Matches(bucket.numbers, bucket.size);
  }

  /** The first so many of some tuple numbers. */
  record Matches(int[] numbers, int size) {}
}
