package org.maestro.knowledge.belief;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Fact;

/**
 * What sources have concluded the last time. Who concludes tells all that it believes each time:
 * what it leaves out it does not believe any more.
 */
public final class Conclusions {
  private final Map<String, Set<StateVariable>> bySource = new TreeMap<>();

  /**
   * Withdraws what the source does not believe any more, and writes what it does. Nothing is left
   * to be written.
   *
   * @param sureness 0 to 1, of each fact
   */
  public List<Fact> take(
      Source source, Map<Fact, Double> sureness, Draft draft, PositionKeeping positions) {
    Set<StateVariable> now = new LinkedHashSet<>();
    sureness.keySet().forEach(fact -> now.add(draft.base().declarations().spokenOf(fact)));
    Set<StateVariable> before = bySource.getOrDefault(source.agent(), Set.of());
    before.stream()
        .filter(variable -> !now.contains(variable))
        .filter(variable -> draft.base().cell(variable).isPresent())
        .forEach(variable -> positions.withdraw(variable, source));
    if (now.isEmpty()) {
      bySource.remove(source.agent());
    } else {
      bySource.put(source.agent(), now);
    }
    sureness.forEach((fact, sure) -> positions.write(List.of(fact), new Voice(source, sure)));
    return List.of();
  }
}
