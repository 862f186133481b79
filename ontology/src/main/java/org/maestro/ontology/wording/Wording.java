package org.maestro.ontology.wording;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;

/**
 * What a home's words are called. Immutable.
 *
 * @param languages which is spoken: by persons, by their local name, and at home, by ""
 * @param names of classes, predicates, things and scripts, by local name
 * @param prepositions of predicates of two arguments, by local name
 * @param describing predicates whose values are adjectives
 * @param measures by the fluent's local name
 * @param topics what constructions are about: their local names, by the topic's
 * @param told how facts of predicates and steps of features are told where not as they are in the
 *     vocabulary, by local name
 * @param grammars those that the home brings: their texts, by the tag of their language
 */
public record Wording(
    Map<String, String> languages,
    Map<String, List<Said>> names,
    Map<String, List<Said>> prepositions,
    Set<String> describing,
    Map<String, Measure> measures,
    List<StateWord> states,
    List<Construction> constructions,
    Map<String, Set<String>> topics,
    Map<String, List<Said>> told,
    Map<String, String> grammars) {
  /** Who speaks as nobody says otherwise. */
  static final String HOME = "";

  /** No words at all. */
  public static final Wording NONE =
      new Wording(
          Map.of(), Map.of(), Map.of(), Set.of(), Map.of(), List.of(), List.of(), Map.of(),
          Map.of(), Map.of());

  public Wording {
    languages = Map.copyOf(languages);
    names = Collections.unmodifiableMap(new TreeMap<>(names));
    prepositions = Collections.unmodifiableMap(new TreeMap<>(prepositions));
    describing = Collections.unmodifiableSet(new TreeSet<>(describing));
    measures = Collections.unmodifiableMap(new TreeMap<>(measures));
    states = List.copyOf(states);
    constructions = List.copyOf(constructions);
    topics = Collections.unmodifiableMap(new TreeMap<>(topics));
    told = Collections.unmodifiableMap(new TreeMap<>(told));
    grammars = Collections.unmodifiableMap(new TreeMap<>(grammars));
  }

  /**
   * The same words, with those constructions alone that are named so, or belong to such a topic.
   */
  public Wording about(Set<String> names) {
    Set<String> wanted = new TreeSet<>(names);
    names.forEach(name -> wanted.addAll(topics.getOrDefault(name, Set.of())));
    return new Wording(
        languages,
        this.names,
        prepositions,
        describing,
        measures,
        states,
        constructions.stream().filter(one -> wanted.contains(one.name())).toList(),
        topics,
        told,
        grammars);
  }

  /**
   * The same words, without those of classes, predicates and things that are not spoken of.
   *
   * @param isSpokenOf by local name
   */
  public Wording of(Predicate<String> isSpokenOf) {
    return new Wording(
        languages,
        kept(names, isSpokenOf),
        kept(prepositions, isSpokenOf),
        describing.stream().filter(isSpokenOf).collect(Collectors.toSet()),
        kept(measures, isSpokenOf),
        states.stream().filter(state -> isSpokenOf.test(state.of())).toList(),
        constructions,
        topics,
        told,
        grammars);
  }

  /**
   * The same words with grammars that are brought.
   *
   * @param texts by the tag of their language
   */
  public Wording spokenBy(Map<String, String> texts) {
    return new Wording(
        languages,
        names,
        prepositions,
        describing,
        measures,
        states,
        constructions,
        topics,
        told,
        texts);
  }

  private static <V> Map<String, V> kept(Map<String, V> all, Predicate<String> isSpokenOf) {
    Map<String, V> kept = new TreeMap<>(all);
    kept.keySet().removeIf(isSpokenOf.negate());
    return kept;
  }

  /** The tag of the language that somebody speaks: his own, else that of the home. */
  public Optional<String> languageOf(String person) {
    return Optional.ofNullable(languages.get(person))
        .or(() -> Optional.ofNullable(languages.get(HOME)));
  }
}
