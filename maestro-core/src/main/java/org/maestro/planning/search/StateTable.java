package org.maestro.planning.search;

import java.util.Arrays;

/** States without repetition, numbered in the order of their first appearance. */
final class StateTable {
  private final int width;
  private long[][] states = new long[1024][];
  private int[] slots = new int[4096];
  private int size;

  StateTable(int width) {
    this.width = width;
    Arrays.fill(slots, -1);
  }

  int size() {
    return size;
  }

  long[] state(int number) {
    return states[number];
  }

  /** About how many bytes the states take. */
  long bytes() {
    return (long) size * (8L * width + 40);
  }

  /** The state's number; the state is kept, and must not be changed, if it is new. */
  int number(long[] state) {
    int slot = slot(state);
    if (slots[slot] >= 0) {
      return slots[slot];
    }
    if (size == states.length) {
      states = Arrays.copyOf(states, 2 * size);
    }
    states[size] = state;
    slots[slot] = size++;
    if (2 * size > slots.length) {
      grow();
    }
    return size - 1;
  }

  private int slot(long[] state) {
    int mask = slots.length - 1;
    int slot = hash(state) & mask;
    while (slots[slot] >= 0 && !Arrays.equals(states[slots[slot]], state)) {
      slot = slot + 1 & mask;
    }
    return slot;
  }

  private static int hash(long[] state) {
    long hash = 0;
    for (long word : state) {
      hash = (hash ^ word) * 0x9E3779B97F4A7C15L;
      hash ^= hash >>> 29;
    }
    return (int) (hash ^ hash >>> 32);
  }

  private void grow() {
    slots = new int[4 * slots.length];
    Arrays.fill(slots, -1);
    for (int number = 0; number < size; number++) {
      slots[slot(states[number])] = number;
    }
  }
}
