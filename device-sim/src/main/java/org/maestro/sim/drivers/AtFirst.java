package org.maestro.sim.drivers;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.maestro.ontology.home.Device;
import org.maestro.sim.scene.Scene;
import org.maestro.sl.Fact;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * How a device is set in the beginning, as a scene says it in the facts that the device reports of
 * itself: {@code (= (volume stereo) 50)} is the volume 50.
 */
final class AtFirst {

  private static final String ON = "on";

  private final Map<String, Term> values = new TreeMap<>();

  private AtFirst() {}

  static AtFirst of(Device device, Scene scene) {
    AtFirst found = new AtFirst();
    List<Fact> states = scene.states(device.id()).stream().map(SlParser::fact).toList();
    device
        .reports()
        .forEach(
            (word, report) ->
                states.stream()
                    .flatMap(state -> value(device.id(), word, report, state).stream())
                    .findFirst()
                    .ifPresent(value -> found.values.put(word, value)));
    return found;
  }

  /** Whether it is switched on. */
  boolean isOn() {
    return new Term.Truth(true).equals(values.get(ON));
  }

  /** All but that, by the device's own words. */
  Map<String, Term> settings() {
    Map<String, Term> settings = new TreeMap<>(values);
    settings.remove(ON);
    return settings;
  }

  /** Whether it is said to be so; empty when nothing is said. */
  Optional<Boolean> truth(String word) {
    return Optional.ofNullable(values.get(word)).map(new Term.Truth(true)::equals);
  }

  /** The value of the word with which its report says what is so. */
  private static Optional<Term> value(String device, String word, String report, Fact state) {
    Fact template =
        new Substitution(Map.of(Self.NAME, new Term.Name(device))).apply(SlParser.fact(report));
    if (template instanceof Fact.Holds holds && state.equals(holds)) {
      return Optional.of(new Term.Truth(true));
    }
    if (template instanceof Fact.Holds holds && state.equals(new Fact.Excluded(holds.atom()))) {
      return Optional.of(new Term.Truth(false));
    }
    return terms(state)
        .filter(
            term -> SlPrinter.print(filled(template, word, term)).equals(SlPrinter.print(state)))
        .findFirst();
  }

  private static Fact filled(Fact template, String word, Term value) {
    return new Substitution(Map.of(word, value)).apply(template);
  }

  private static Stream<Term> terms(Fact state) {
    if (state instanceof Fact.Equation equation) {
      return Stream.of(equation.value());
    }
    return state instanceof Fact.Holds holds ? holds.atom().arguments().stream() : Stream.empty();
  }
}
