package org.maestro.language;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Construction;
import org.maestro.ontology.wording.Wording;

/**
 * A home as somebody knows it who can speak of some topics only (ADE, 5; A13, A73): the
 * constructions that belong to them, the things that can be spoken of by these, and what is said of
 * such things. Rooms and persons everybody knows.
 */
final class TopicsOfHome {
  private static final Set<String> KNOWN_TO_ALL = Set.of("Person", "Room", "Zone");

  private TopicsOfHome() {}

  /**
   * @param topics names of topics and of constructions
   */
  static Home of(Home whole, Set<String> topics) {
    Wording wording = whole.wording().about(topics);
    Set<String> types =
        Stream.concat(
                KNOWN_TO_ALL.stream(),
                wording.constructions().stream()
                    .flatMap(construction -> construction.roles().stream())
                    .map(Construction.Role::type))
            .collect(Collectors.toSet());
    Map<String, Individual> things = new TreeMap<>(whole.individuals());
    things.values().removeIf(thing -> thing.classes().stream().noneMatch(types::contains));
    Set<String> classes =
        things.values().stream()
            .flatMap(thing -> thing.classes().stream())
            .collect(Collectors.toSet());
    return whole.knownAs(things, wording.of(word -> isSpokenOf(word, whole, things, classes)));
  }

  /** A class that has a thing, a predicate of such things, a thing; any other word. */
  private static boolean isSpokenOf(
      String word, Home whole, Map<String, Individual> things, Set<String> classes) {
    if (whole.vocabulary().classes().containsKey(word)) {
      return classes.contains(word);
    }
    Optional<PredicateDeclaration> predicate = whole.vocabulary().predicate(word);
    if (predicate.isPresent()) {
      return predicate.get().parameters().stream()
          .flatMap(one -> one.className().stream())
          .filter(whole.vocabulary().classes()::containsKey)
          .allMatch(classes::contains);
    }
    return !whole.individuals().containsKey(word) || things.containsKey(word);
  }
}
