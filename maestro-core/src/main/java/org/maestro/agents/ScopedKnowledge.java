package org.maestro.agents;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.maestro.knowledge.ForwardingKnowledge;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;

/** The collective knowledge, with only those devices to plan with that are in an agent's scope. */
final class ScopedKnowledge extends ForwardingKnowledge {
  private final Predicate<String> scope;

  ScopedKnowledge(KnowledgeBase knowledge, Predicate<String> scope) {
    super(knowledge);
    this.scope = scope;
  }

  @Override
  public Home home() {
    Home home = super.home();
    Map<String, Device> devices = new TreeMap<>(home.devices());
    devices.keySet().removeIf(scope.negate());
    return new Home(
        home.iri(), home.label(), home.vocabulary(), home.individuals(), devices, home.groups());
  }

  @Override
  public void lost(String member) {
    // Only the central agent, which hears of all members, says so for all.
  }
}
