package org.maestro.coordination.api;

import java.util.Collection;
import java.util.Collections;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.ToLongFunction;

/**
 * A bounded memory of goals that are over: the latest, as many as fit into so many bytes. Not safe
 * for use by several threads.
 */
public final class Latest<V> {
  private final long mostBytes;
  private final ToLongFunction<V> bytes;
  private final Map<String, V> byGoal = new LinkedHashMap<>();
  private long kept;

  /**
   * @param bytes that one of them takes, about
   */
  public Latest(long mostBytes, ToLongFunction<V> bytes) {
    this.mostBytes = mostBytes;
    this.bytes = bytes;
  }

  /** The newest is kept whatever it takes. */
  public void put(String goalId, V value) {
    remove(goalId);
    byGoal.put(goalId, value);
    kept += bytes.applyAsLong(value);
    Iterator<V> oldest = byGoal.values().iterator();
    while (kept > mostBytes && byGoal.size() > 1) {
      kept -= bytes.applyAsLong(oldest.next());
      oldest.remove();
    }
  }

  public void remove(String goalId) {
    Optional.ofNullable(byGoal.remove(goalId)).ifPresent(old -> kept -= bytes.applyAsLong(old));
  }

  public Optional<V> find(String goalId) {
    return Optional.ofNullable(byGoal.get(goalId));
  }

  /** Oldest first. */
  public Collection<V> values() {
    return Collections.unmodifiableCollection(byGoal.values());
  }

  /** Of their goals, oldest first. */
  public Set<String> ids() {
    return Collections.unmodifiableSet(byGoal.keySet());
  }
}
