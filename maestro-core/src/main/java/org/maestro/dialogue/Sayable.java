package org.maestro.dialogue;

import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.wording.Said;

/**
 * What can be said in a home.
 *
 * @param patterns of sentences, with roles in braces
 * @param names of rooms, things and persons
 */
public record Sayable(List<String> patterns, List<String> names) {
  private static final Set<String> HOUSEHOLD = Set.of("Room", "Device", "Thing", "Location");

  public Sayable {
    patterns = List.copyOf(patterns);
    names = List.copyOf(names);
  }

  /**
   * What can be said there, for who does not know the home.
   *
   * @param language its tag
   */
  public static Sayable of(Home home, String language) {
    List<String> patterns =
        home.wording().constructions().stream()
            .flatMap(one -> in(language, one.says()).stream().limit(1))
            .toList();
    List<String> names =
        home.wording().names().entrySet().stream()
            .filter(named -> isOfTheHouse(home.individuals().get(named.getKey())))
            .flatMap(named -> in(language, named.getValue()).stream().limit(1))
            .distinct()
            .toList();
    return new Sayable(patterns, names);
  }

  /** There may be thousands of titles. */
  private static boolean isOfTheHouse(@Nullable Individual individual) {
    return individual != null
        && HOUSEHOLD.stream().anyMatch(kind -> individual.classes().contains(kind));
  }

  private static List<String> in(String language, List<Said> words) {
    return words.stream().filter(said -> said.isIn(language)).map(Said::text).toList();
  }
}
