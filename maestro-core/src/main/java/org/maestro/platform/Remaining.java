package org.maestro.platform;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.ontology.home.Device;

/** The abilities left when a device is out of use, and those that are not (ADE, 3.2; A38). */
final class Remaining {
  private Remaining() {}

  /**
   * In half a sentence: who else does what it did, and what nobody does any more.
   *
   * @param others devices that are there
   */
  static String inWords(Device lost, Collection<Device> others) {
    Map<String, List<String>> othersByFeature = new TreeMap<>();
    lost.features().forEach(feature -> othersByFeature.put(feature.name(), new ArrayList<>()));
    for (Device other : others) {
      new TreeSet<>(other.features().stream().map(feature -> feature.name()).toList())
          .stream()
              .filter(name -> !other.id().equals(lost.id()))
              .map(othersByFeature::get)
              .filter(Objects::nonNull)
              .forEach(able -> able.add(other.id()));
    }
    List<String> parts = new ArrayList<>();
    Map<String, List<String>> featuresByOthers = new TreeMap<>();
    othersByFeature.forEach(
        (feature, able) ->
            featuresByOthers
                .computeIfAbsent(String.join(" and ", able), names -> new ArrayList<>())
                .add(feature));
    List<String> missing = featuresByOthers.remove("");
    featuresByOthers.forEach(
        (able, features) ->
            parts.add("use %s for %s".formatted(able, String.join(", ", features))));
    if (missing != null) {
      parts.add("nobody else can %s".formatted(String.join(", ", missing)));
    }
    return String.join("; ", parts);
  }
}
