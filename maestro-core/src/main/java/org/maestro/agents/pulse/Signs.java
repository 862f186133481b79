package org.maestro.agents.pulse;

import java.util.Collections;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * What is known of containers and agents by their signs of life, at one time.
 *
 * @param timing as it is now: longer than usual where all are slow
 * @param containers by name
 * @param agents that do nothing though their containers live, by name
 */
public record Signs(
    HeartbeatSettings timing,
    SortedMap<String, LifeSign> containers,
    SortedMap<String, Condition> agents) {
  public Signs {
    containers = Collections.unmodifiableSortedMap(new TreeMap<>(containers));
    agents = Collections.unmodifiableSortedMap(new TreeMap<>(agents));
  }

  /** Where nobody is watched. */
  public static Signs none() {
    return new Signs(HeartbeatSettings.standard(), new TreeMap<>(), new TreeMap<>());
  }

  /** The condition of each container. */
  public SortedMap<String, Condition> conditions() {
    SortedMap<String, Condition> conditions = new TreeMap<>();
    containers.forEach((name, sign) -> conditions.put(name, sign.condition()));
    return conditions;
  }
}
