package org.maestro.ontology.home;

import java.util.Collections;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Synonyms;

/**
 * What the description of a device brings into a home beside the device.
 *
 * @param words classes and predicates that its maker declares
 * @param things by local name: what it deals in
 * @param synonyms what it calls otherwise than the home and other makers
 * @param borrowed those of the words that are another maker's, as the description only says that
 *     its own mean the same: how their maker declares them counts
 */
public record Extension(
    Vocabulary words, Map<String, Individual> things, Synonyms synonyms, Set<String> borrowed) {

  public static final Extension NONE =
      new Extension(Vocabulary.EMPTY, Map.of(), Synonyms.NONE, Set.of());

  private static final String THING = "Thing";

  /** What only a home says: its map, who may ask whom, and who is there. */
  private static final Set<String> FOR_THE_HOME =
      Set.of(
          "Permission",
          "Place",
          "Location",
          "Zone",
          "Room",
          "Door",
          "Wall",
          "Window",
          "Device",
          "GroupAgent",
          "Home");

  public Extension {
    things = Collections.unmodifiableMap(new TreeMap<>(things));
    borrowed = Set.copyOf(borrowed);
  }

  /** The same with these things. */
  public Extension with(Map<String, Individual> present) {
    return new Extension(words, present, synonyms, borrowed);
  }

  /** What it says of words beside what their makers, who are there, say of them. */
  Vocabulary wordsBeside(Vocabulary there) {
    return words.without(
        borrowed.stream().filter(name -> there.iri(name).isPresent()).collect(Collectors.toSet()));
  }

  /** A word that both declare, and not alike. */
  Optional<String> unlike(Extension other) {
    Set<String> lent = new TreeSet<>(borrowed);
    lent.addAll(other.borrowed);
    return words.unlike(other.words, lent);
  }

  /**
   * Whether a thing of all these classes may come with a device: what has a say in the map or in
   * rights may not.
   *
   * @param classes local names, with those that they are under
   */
  public static boolean mayBring(Set<String> classes) {
    return objection(classes).isEmpty();
  }

  /** Why it may not. */
  static Optional<Contradiction> objection(Set<String> classes) {
    String all = String.join(", ", classes);
    if (!Collections.disjoint(classes, FOR_THE_HOME)) {
      return Optional.of(
          new Contradiction(
              "is of classes that a device does not bring (%s)".formatted(all),
              "give it a class under maestro:Thing, and none of places, devices or permissions"));
    }
    return classes.contains(THING)
        ? Optional.empty()
        : Optional.of(
            new Contradiction(
                "is of no class that is under maestro:Thing (%s)".formatted(all),
                "write that its class is under it (subClassOf), beside what it is under or the same"
                    + " as with other makers"));
  }
}
