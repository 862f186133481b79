package org.maestro.agents.goals;

import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;

/** The collective knowledge, with only those devices to plan with that are in an agent's scope. */
final class ScopedKnowledge extends ForwardingKnowledge {
  /** A home, and what of it is in scope. */
  private record Part(Home whole, Home home) {
    static Part of(Home whole, Set<String> inScope) {
      Map<String, Device> devices = new TreeMap<>(whole.devices());
      devices.keySet().retainAll(inScope);
      return new Part(whole, whole.withDevices(devices));
    }
  }

  private final Predicate<String> scope;
  private volatile @Nullable Part last;

  ScopedKnowledge(KnowledgeBase knowledge, Predicate<String> scope) {
    super(knowledge);
    this.scope = scope;
  }

  @Override
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  public Home home() {
    Home whole = super.home();
    Set<String> inScope = new TreeSet<>(whole.devices().keySet());
    inScope.removeIf(scope.negate());
    Part part = last;
    if (part == null || part.whole() != whole || !part.home().devices().keySet().equals(inScope)) {
      part = Part.of(whole, inScope);
      last = part;
    }
    return part.home();
  }

  @Override
  public void lost(String member) {
    // Only the central agent, which hears of all members, says so for all.
  }
}
