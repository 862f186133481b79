package org.maestro.planning;

import java.util.List;

/** What planning ends with. */
public sealed interface PlanningResult {

  /** The cheapest plan, proven so. */
  record Found(Plan plan) implements PlanningResult {}

  /** Proven: no plan exists. */
  record Impossible(Explanation explanation) implements PlanningResult {}

  /** Neither plan nor proof within the bounds given; the sentence says which bound. */
  record GaveUp(String reason) implements PlanningResult {}

  /** Why no plan exists: conditions, jointly necessary, that nobody can bring about. */
  record Explanation(List<Obstacle> obstacles) {}

  /**
   * A condition that cannot be met.
   *
   * @param condition ground, in MAESTRO-SL: {@code (>= (illuminance zone-b) 72)}
   * @param needed what is needed, for people: {@code >= 72}
   * @param possible the best that can be reached or what is known: {@code 42}, {@code known false},
   *     {@code no agent can change it}
   * @param neededBy the feature instance or goal that needs it, for people
   */
  record Obstacle(String condition, String needed, String possible, String neededBy) {}
}
