package org.maestro.coordination;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.PricedFeature;
import org.maestro.planning.Unavailable;

/**
 * What steps have shown of members beyond their descriptions, for all goals of a coordinator:
 * features of which the results teach nothing again and again. Forgotten when the member describes
 * itself anew. The coordinator's thread only.
 */
final class Experience {
  /** So many results in a row may teach nothing. */
  private static final int MOST_USELESS = 3;

  private record Key(String member, String feature) {}

  private record Useless(int inARow, String latest) {}

  private final Map<Key, Useless> useless = new HashMap<>();

  /**
   * A result taught nothing.
   *
   * @param problem one sentence
   */
  void taughtNothing(String member, String feature, String problem) {
    useless.merge(
        new Key(member, feature),
        new Useless(1, Sentences.withoutFullStop(problem)),
        (before, now) -> new Useless(before.inARow() + 1, now.latest()));
  }

  /** A result was as described. */
  void taught(String member, String feature) {
    useless.remove(new Key(member, feature));
  }

  /** The member has described itself anew; what was before says nothing any more. */
  void forget(String member) {
    useless.keySet().removeIf(key -> key.member().equals(member));
  }

  /** Why the feature is left alone; empty when it is not. */
  Optional<String> leftAlone(String member, String feature) {
    return Optional.ofNullable(useless.get(new Key(member, feature)))
        .filter(known -> known.inARow() >= MOST_USELESS)
        .map(
            known ->
                "it is not asked for %s any more, after %d results in a row that taught nothing: %s"
                    .formatted(feature, known.inARow(), known.latest()));
  }

  /** Whether any feature of the member is left alone. */
  boolean isDoubted(String member) {
    return useless.keySet().stream()
        .filter(key -> key.member().equals(member))
        .anyMatch(key -> leftAlone(member, key.feature()).isPresent());
  }

  /** What of this can be counted on. */
  List<PricedFeature> reliable(List<PricedFeature> offered) {
    return offered.stream().filter(f -> leftAlone(f.member(), f.type().name()).isEmpty()).toList();
  }

  /** What of this cannot be counted on, each with its reason. */
  List<Unavailable> unreliable(List<PricedFeature> offered) {
    List<Unavailable> left = new ArrayList<>();
    for (PricedFeature feature : offered) {
      leftAlone(feature.member(), feature.type().name())
          .ifPresent(why -> left.add(new Unavailable(feature, why)));
    }
    return left;
  }
}
