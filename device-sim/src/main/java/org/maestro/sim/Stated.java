package org.maestro.sim;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.ontology.home.Device;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * What the home states of a device by the words of its own procedures: such as {@code payload},
 * which its description says to mean {@code (payload ?self)}. What a word means stands in the
 * vocabulary.
 */
final class Stated {
  private static final List<Term> SELF = List.of(new Term.Variable("self"));

  private Stated() {}

  /** Empty when no procedure of the device knows the word, or the home says nothing of it. */
  static OptionalDouble number(Device device, String word) {
    return property(device, word)
        .map(property -> FloorMap.number(device.individual(), property))
        .orElse(OptionalDouble.empty());
  }

  /** Whether the home says that it is so. */
  static boolean truth(Device device, String word) {
    return property(device, word)
        .map(property -> device.individual().properties().getOrDefault(property, List.of()))
        .filter(values -> values.contains(new Term.Truth(true)))
        .isPresent();
  }

  private static Optional<String> property(Device device, String word) {
    return device.features().stream()
        .flatMap(feature -> Optional.ofNullable(feature.refersTo().get(word)).stream())
        .map(SlParser::fact)
        .filter(Fact.Holds.class::isInstance)
        .map(fact -> ((Fact.Holds) fact).atom())
        .filter(atom -> atom.arguments().equals(SELF))
        .map(Formula.Atom::predicate)
        .findFirst();
  }
}
