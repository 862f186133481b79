package org.maestro.sim.drivers;

import java.util.List;
import java.util.OptionalDouble;
import org.maestro.ontology.home.Device;
import org.maestro.sim.world.FloorMap;
import org.maestro.sl.Term;

/**
 * Properties that the home states of a device, by the words of its own procedures: such as {@code
 * payload}, which its description says to mean {@code (payload ?self)}. What a word means stands in
 * the vocabulary.
 */
final class Stated {
  private Stated() {}

  /** Empty when no procedure of the device knows the word, or the home says nothing of it. */
  static OptionalDouble number(Device device, String word) {
    return device
        .propertyCalled(word)
        .map(property -> FloorMap.number(device.individual(), property))
        .orElse(OptionalDouble.empty());
  }

  /** Whether the home says that it is so. */
  static boolean truth(Device device, String word) {
    return device
        .propertyCalled(word)
        .map(property -> device.individual().properties().getOrDefault(property, List.of()))
        .filter(values -> values.contains(new Term.Truth(true)))
        .isPresent();
  }
}
