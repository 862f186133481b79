package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;

/**
 * The features that could take part in reaching a goal: those that change what it speaks of, or
 * what a relevant feature's condition speaks of, and so on backwards. Works on names, not on
 * instances: a superset of what any plan needs.
 */
public final class Relevance {
  private final Home home;
  private final Set<String> relevant = new TreeSet<>();

  /** By identity, as devices of a kind are many and share what their features say. */
  private final IdentityHashMap<Effect, Set<String>> changedBy = new IdentityHashMap<>();

  private final IdentityHashMap<Object, Object> included = new IdentityHashMap<>();

  private Relevance(Home home) {
    this.home = home;
  }

  /** Names of the relevant features by device id, devices in declared order. */
  public static Map<String, List<String>> candidates(Formula goal, Home home) {
    Relevance relevance = new Relevance(home);
    relevance.include(Symbols.of(goal));
    Map<String, List<String>> candidates = new LinkedHashMap<>();
    List<Device> devices =
        home.devices().values().stream()
            .sorted(Comparator.comparingDouble(Device::order).thenComparing(Device::id))
            .toList();
    boolean grew = true;
    while (grew) {
      grew = false;
      for (Device device : devices) {
        List<String> chosen = candidates.computeIfAbsent(device.id(), id -> new ArrayList<>());
        for (FeatureType feature : device.features()) {
          if (!chosen.contains(feature.name()) && relevance.changesRelevant(feature)) {
            chosen.add(feature.name());
            relevance.includeNeeds(feature.precondition(), feature.effect());
            grew = true;
          }
        }
      }
    }
    candidates.values().removeIf(List::isEmpty);
    return candidates;
  }

  private boolean changesRelevant(FeatureType feature) {
    return changedBy.computeIfAbsent(feature.effect(), Symbols::changedBy).stream()
        .anyMatch(relevant::contains);
  }

  private void includeNeeds(Formula precondition, Effect effect) {
    if (included.put(precondition, precondition) == null) {
      include(Symbols.of(precondition));
    }
    if (included.put(effect, effect) == null) {
      include(Symbols.readBy(effect));
    }
  }

  private void include(Set<String> names) {
    Vocabulary vocabulary = home.vocabulary();
    for (String name : names) {
      if (relevant.add(name)) {
        vocabulary
            .predicate(name)
            .flatMap(PredicateDeclaration::derivedWhen)
            .map(Symbols::of)
            .ifPresent(this::include);
      }
    }
  }
}
