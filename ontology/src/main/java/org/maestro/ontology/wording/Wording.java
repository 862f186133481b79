package org.maestro.ontology.wording;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What a home's words are called. Immutable.
 *
 * @param languages which is spoken: by persons, by their local name, and at home, by ""
 * @param names of classes, predicates, things and scripts, by local name
 * @param prepositions of predicates of two arguments, by local name
 * @param describing predicates whose values are adjectives
 * @param measures by the fluent's local name
 */
public record Wording(
    Map<String, String> languages,
    Map<String, List<Said>> names,
    Map<String, List<Said>> prepositions,
    Set<String> describing,
    Map<String, Measure> measures,
    List<StateWord> states,
    List<Construction> constructions) {
  /** Who speaks as nobody says otherwise. */
  static final String HOME = "";

  /** No words at all. */
  public static final Wording NONE =
      new Wording(Map.of(), Map.of(), Map.of(), Set.of(), Map.of(), List.of(), List.of());

  public Wording {
    languages = Map.copyOf(languages);
    names = Collections.unmodifiableMap(new TreeMap<>(names));
    prepositions = Collections.unmodifiableMap(new TreeMap<>(prepositions));
    describing = Collections.unmodifiableSet(new TreeSet<>(describing));
    measures = Collections.unmodifiableMap(new TreeMap<>(measures));
    states = List.copyOf(states);
    constructions = List.copyOf(constructions);
  }

  /** The tag of the language that somebody speaks: his own, else that of the home. */
  public Optional<String> languageOf(String person) {
    return Optional.ofNullable(languages.get(person))
        .or(() -> Optional.ofNullable(languages.get(HOME)));
  }
}
