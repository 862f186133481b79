package org.maestro.planning.grounding;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.problem.Signature;
import org.maestro.planning.problem.VariableValue;

/** The features of a task by number. A feature keeps its number while others come and go. */
final class Offers {
  private record Name(String member, String feature) {}

  private final List<PricedFeature> features = new ArrayList<>();
  private final List<OptionalInt> kin = new ArrayList<>();
  private final IdentityHashMap<FeatureType, Set<String>> addedBy = new IdentityHashMap<>();
  private final Map<String, List<Integer>> changing = new HashMap<>();
  private final Map<Integer, Integer> ranks = new HashMap<>();
  private final Set<String> removed = new HashSet<>();

  Offers(List<PricedFeature> features) {
    become(features);
  }

  /** Takes these, in their order; equal ones keep their numbers, others get new ones. */
  final void become(List<PricedFeature> next) {
    Map<Name, List<Integer>> known = new HashMap<>();
    for (int i = 0; i < features.size(); i++) {
      known.computeIfAbsent(name(features.get(i)), absent -> new ArrayList<>()).add(i);
    }
    changing.clear();
    ranks.clear();
    removed.clear();
    IdentityHashMap<FeatureType, Set<String>> changedBy = new IdentityHashMap<>();
    for (PricedFeature feature : next) {
      int number = number(feature, known.getOrDefault(name(feature), List.of()));
      ranks.put(number, ranks.size());
      for (String name :
          changedBy.computeIfAbsent(feature.type(), type -> Signature.changedBy(type.effect()))) {
        changing.computeIfAbsent(name, absent -> new ArrayList<>()).add(number);
      }
    }
    changedBy.keySet().forEach(type -> removed.addAll(Signature.removedBy(type.effect())));
  }

  private static Name name(PricedFeature feature) {
    return new Name(feature.member(), feature.type().name());
  }

  @SuppressWarnings("ReferenceEquality") // A type is told by its object, as in addedBy.
  private int number(PricedFeature feature, List<Integer> known) {
    for (int number : known) {
      if (!ranks.containsKey(number) && features.get(number).equals(feature)) {
        return number;
      }
    }
    kin.add(
        known.stream()
            .filter(number -> features.get(number).type() == feature.type())
            .filter(number -> features.get(number).price().equals(feature.price()))
            .mapToInt(number -> number)
            .findFirst());
    features.add(feature);
    return features.size() - 1;
  }

  /** An earlier feature that differs only in prices which the member itself has given. */
  OptionalInt kin(int number) {
    return kin.get(number);
  }

  /** The numbers of all that are there now. */
  Set<Integer> there() {
    return Set.copyOf(ranks.keySet());
  }

  /** How many numbers there are, of features that went too. */
  int numbers() {
    return features.size();
  }

  PricedFeature feature(int number) {
    return features.get(number);
  }

  /** Whether the feature is of the task now. */
  boolean isThere(int number) {
    return ranks.containsKey(number);
  }

  /** The place in the task's order of a feature that is there. */
  int rank(int number) {
    return Objects.requireNonNull(ranks.get(number));
  }

  /** Numbers of the features that may change a predicate or fluent, in the task's order. */
  List<Integer> changing(String name) {
    return changing.getOrDefault(name, List.of());
  }

  /** Only what is not known can be found. */
  boolean mayBringAbout(FeatureType type, VariableValue aim) {
    return aim.isFindable()
        || removed.contains(aim.variable().predicate())
        || addedBy
            .computeIfAbsent(type, absent -> Signature.addedBy(type.effect()))
            .contains(aim.variable().predicate());
  }
}
