package org.maestro.planning.search;

import java.util.Arrays;

/** Numbers with keys, the least key first; among equal keys the one that came first. */
final class IntHeap {
  private long[] keys = new long[256];
  private long[] entries = new long[256];
  private int size;
  private int sequence;

  boolean isEmpty() {
    return size == 0;
  }

  int size() {
    return size;
  }

  /** How many bytes the entries take. */
  long bytes() {
    return 16L * keys.length;
  }

  void clear() {
    size = 0;
    sequence = 0;
  }

  long leastKey() {
    return keys[0];
  }

  void add(long key, int value) {
    add(key, sequence++, value);
  }

  /** Among equal keys the one with the least tie comes first. */
  void add(long key, int tie, int value) {
    if (size == keys.length) {
      keys = Arrays.copyOf(keys, 2 * size);
      entries = Arrays.copyOf(entries, 2 * size);
    }
    long entry = (long) tie << 32 | value & 0xffffffffL;
    int at = size++;
    while (at > 0) {
      int parent = at - 1 >> 1;
      if (!isBefore(key, entry, parent)) {
        break;
      }
      keys[at] = keys[parent];
      entries[at] = entries[parent];
      at = parent;
    }
    keys[at] = key;
    entries[at] = entry;
  }

  private boolean isBefore(long key, long entry, int other) {
    return key < keys[other] || key == keys[other] && entry < entries[other];
  }

  int removeLeast() {
    int least = (int) entries[0];
    long key = keys[--size];
    long entry = entries[size];
    int at = 0;
    while (true) {
      int child = 2 * at + 1;
      if (child >= size) {
        break;
      }
      if (child + 1 < size && isBefore(keys[child + 1], entries[child + 1], child)) {
        child++;
      }
      if (isBefore(key, entry, child)) {
        break;
      }
      keys[at] = keys[child];
      entries[at] = entries[child];
      at = child;
    }
    if (size > 0) {
      keys[at] = key;
      entries[at] = entry;
    }
    return least;
  }
}
