package org.maestro.planning.optimal;

import java.util.Arrays;

/** A binary heap of numbers with double keys, without boxing. */
public final class PropositionQueue {
  private double[] keys = new double[64];
  private int[] entries = new int[64];
  private int size;

  public void clear() {
    size = 0;
  }

  public boolean isEmpty() {
    return size == 0;
  }

  public double leastKey() {
    return keys[0];
  }

  public void add(double key, int entry) {
    if (size == keys.length) {
      keys = Arrays.copyOf(keys, 2 * size);
      entries = Arrays.copyOf(entries, 2 * size);
    }
    int at = size++;
    while (at > 0 && keys[(at - 1) / 2] > key) {
      int parent = (at - 1) / 2;
      keys[at] = keys[parent];
      entries[at] = entries[parent];
      at = parent;
    }
    keys[at] = key;
    entries[at] = entry;
  }

  public int removeLeast() {
    int least = entries[0];
    double key = keys[--size];
    int entry = entries[size];
    int at = 0;
    while (2 * at + 1 < size) {
      int child = 2 * at + 1;
      if (child + 1 < size && keys[child + 1] < keys[child]) {
        child++;
      }
      if (keys[child] >= key) {
        break;
      }
      keys[at] = keys[child];
      entries[at] = entries[child];
      at = child;
    }
    keys[at] = key;
    entries[at] = entry;
    return least;
  }
}
