package org.maestro.coordination;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Formula;

/**
 * Which features could take part in reaching a goal: those that change what it speaks of, or what a
 * relevant feature's condition speaks of, and so on backwards. Works on names, not on instances: a
 * superset of what any plan needs.
 */
final class Relevance {
  private final Home home;
  private final Set<String> relevant = new TreeSet<>();

  private Relevance(Home home) {
    this.home = home;
  }

  /** Names of the relevant features by device id. */
  static Map<String, List<String>> candidates(Formula goal, Home home) {
    Relevance relevance = new Relevance(home);
    relevance.include(Symbols.of(goal));
    Map<String, List<String>> candidates = new TreeMap<>();
    boolean grew = true;
    while (grew) {
      grew = false;
      for (Device device : home.devices().values()) {
        for (FeatureType feature : device.features()) {
          List<String> chosen = candidates.computeIfAbsent(device.id(), id -> new ArrayList<>());
          if (!chosen.contains(feature.name()) && relevance.changesRelevant(feature)) {
            chosen.add(feature.name());
            relevance.include(Symbols.of(feature.precondition()));
            relevance.include(Symbols.readBy(feature.effect()));
            grew = true;
          }
        }
      }
    }
    candidates.values().removeIf(List::isEmpty);
    return candidates;
  }

  private boolean changesRelevant(FeatureType feature) {
    return Symbols.changedBy(feature.effect()).stream().anyMatch(relevant::contains);
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
