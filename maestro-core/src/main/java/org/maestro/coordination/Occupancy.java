package org.maestro.coordination;

import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * Which components of which member are in use, so that goals do not order a member to do two things
 * at once.
 */
final class Occupancy {
  private final Map<String, String> holderByComponent = new HashMap<>();

  boolean isFree(String member, Set<String> components) {
    return components.stream().noneMatch(c -> holderByComponent.containsKey(key(member, c)));
  }

  void take(String member, Set<String> components, String holder) {
    components.forEach(c -> holderByComponent.put(key(member, c), holder));
  }

  void release(String member, Set<String> components, String holder) {
    components.forEach(c -> holderByComponent.remove(key(member, c), holder));
  }

  /** Who holds what of the member, for people. */
  String holders(String member, Set<String> components) {
    return components.stream()
        .filter(c -> holderByComponent.containsKey(key(member, c)))
        .sorted()
        .map(
            c ->
                "the "
                    + c
                    + " of "
                    + member
                    + " is held by "
                    + holderByComponent.get(key(member, c)))
        .collect(Collectors.joining(", "));
  }

  private static String key(String member, String component) {
    return member + "/" + component;
  }
}
