package org.maestro.rats.bounded;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * A map that holds so many entries at most: a new one takes the place of the oldest. Not safe for
 * use by several threads.
 */
public final class BoundedMap<K, V> extends LinkedHashMap<K, V> {
  private static final long serialVersionUID = 1L;
  private static final int INITIAL_CAPACITY = 16;
  private static final float LOAD_FACTOR = 0.75f;

  private final int most;

  private BoundedMap(int most, boolean byUse) {
    super(INITIAL_CAPACITY, LOAD_FACTOR, byUse);
    this.most = most;
  }

  /** One that forgets first what was put first. */
  public static <K, V> Map<K, V> ofNewest(int most) {
    return new BoundedMap<>(most, false);
  }

  /** One that forgets first what was not looked at for the longest time. */
  public static <K, V> Map<K, V> ofLatelyUsed(int most) {
    return new BoundedMap<>(most, true);
  }

  @Override
  protected boolean removeEldestEntry(Map.Entry<K, V> eldest) {
    return size() > most;
  }
}
