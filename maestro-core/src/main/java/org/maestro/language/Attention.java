package org.maestro.language;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;

/**
 * What it is certain to be about while words are still to come: who listens may look at it (A63).
 */
final class Attention {
  private Attention() {}

  /** The things that alone can be meant by what was said, whichever of these it will be. */
  static List<String> of(List<Understanding.UnderWay> readings) {
    Map<String, List<Understanding.UnderWay>> byConstruction =
        readings.stream()
            .collect(
                Collectors.groupingBy(
                    Understanding.UnderWay::construction, LinkedHashMap::new, Collectors.toList()));
    List<String> meant = new ArrayList<>();
    byConstruction.values().stream().limit(1).forEach(first -> meant.addAll(alone(first)));
    byConstruction.values().forEach(others -> meant.retainAll(alone(others)));
    return List.copyOf(meant);
  }

  /** The same where it is certain already which it is, if nothing else follows. */
  static List<String> ofBest(List<Understanding.UnderWay> readings) {
    return of(
        readings.stream()
            .filter(one -> one.construction().equals(readings.get(0).construction()))
            .toList());
  }

  /** Of readings of one construction. */
  private static Set<String> alone(List<Understanding.UnderWay> readings) {
    Set<String> alone = new LinkedHashSet<>();
    readings.get(0).roles().keySet().forEach(role -> alone.addAll(alone(role, readings)));
    return alone;
  }

  /** A phrase that could be several things may be about to be told more closely. */
  private static List<String> alone(String role, List<Understanding.UnderWay> readings) {
    List<String> alone =
        readings.stream()
            .filter(one -> one.said().contains(role))
            .map(one -> one.roles().getOrDefault(role, List.of()))
            .filter(things -> things.size() == 1)
            .map(things -> things.get(0))
            .distinct()
            .toList();
    return alone.size() == 1 ? alone : List.of();
  }
}
