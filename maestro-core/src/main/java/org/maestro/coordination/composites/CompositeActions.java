package org.maestro.coordination.composites;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Ports;
import org.maestro.ontology.home.Script;

/**
 * The world of planning with scripts among the members: plans find them beside the devices'
 * features, by their stated effect and cost, and their steps are scripts carried out. A script is
 * never a step of what it does itself. The coordinator's thread only.
 */
public final class CompositeActions {
  private final Ports ports;
  private final ScriptRuns runs;

  /**
   * @param ports of a world without scripts
   */
  public CompositeActions(Ports ports, ScriptRuns runs) {
    this.ports = ports;
    this.runs = runs;
  }

  /** The world in which goals are pursued that are asked for. */
  public Ports ports() {
    return ports(Set.of());
  }

  /** The same within a script, which is no step there. */
  public Ports within(Script script) {
    return script.action().isEmpty() ? ports() : ports(Set.of(script.name()));
  }

  private Ports ports(Set<String> without) {
    return isAny()
        ? ports.with(
            new WithScripts(ports.knowledge(), without),
            new ScriptBids(ports.contractNet(), ports.knowledge()),
            new ScriptCalls(ports, runs, name -> within(without, name)))
        : ports;
  }

  private Ports within(Set<String> others, String name) {
    Set<String> without = new HashSet<>(others);
    without.add(name);
    return ports(without);
  }

  /** Whether the home has a script that plans may use. */
  public boolean isAny() {
    return ports.knowledge().home().scripts().values().stream()
        .map(Script::action)
        .anyMatch(Optional::isPresent);
  }
}
