package org.maestro.coordination.composites;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.Script;
import org.maestro.ontology.vocabulary.FeatureType;

/** The collective knowledge, with the scripts that plans may use as features of one more member. */
final class WithScripts extends ForwardingKnowledge {
  private final Set<String> without;
  private volatile @Nullable Seen last;

  /** A home, and the same with scripts among its members. */
  private record Seen(Home whole, Home home) {}

  /**
   * @param without names of scripts that are left out
   */
  WithScripts(KnowledgeBase knowledge, Set<String> without) {
    super(knowledge);
    this.without = Set.copyOf(without);
  }

  @Override
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  public Home home() {
    Home whole = super.home();
    Seen seen = last;
    if (seen == null || seen.whole() != whole) {
      seen = new Seen(whole, with(whole));
      last = seen;
    }
    return seen.home();
  }

  private Home with(Home whole) {
    List<FeatureType> actions =
        whole.scripts().values().stream()
            .filter(script -> !without.contains(script.name()))
            .flatMap(script -> script.action().stream())
            .toList();
    if (actions.isEmpty()) {
      return whole;
    }
    Map<String, Device> members = new TreeMap<>(whole.devices());
    members.put(Script.PLANNED_AS, member(actions));
    return whole.withDevices(members);
  }

  private static Device member(List<FeatureType> actions) {
    return new Device(
        new Individual(
            Script.PLANNED_AS, "", "the scripts of the home", new TreeSet<>(), new TreeMap<>()),
        Optional.empty(),
        Optional.empty(),
        new ArrayList<>(actions),
        Map.of());
  }
}
