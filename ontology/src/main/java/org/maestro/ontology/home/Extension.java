package org.maestro.ontology.home;

import java.util.Collections;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Synonyms;

/**
 * What the description of a device brings into a home beside the device.
 *
 * @param words classes and predicates that its maker declares
 * @param things by local name: what it deals in
 * @param synonyms what it calls otherwise than the home and other makers
 */
public record Extension(Vocabulary words, Map<String, Individual> things, Synonyms synonyms) {

  public static final Extension NONE = new Extension(Vocabulary.EMPTY, Map.of(), Synonyms.NONE);

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
  }

  /**
   * Whether a thing of all these classes may come with a device: what has a say in the map or in
   * rights may not.
   *
   * @param classes local names, with those that they are under
   */
  public static boolean mayBring(Set<String> classes) {
    return classes.contains(THING) && Collections.disjoint(classes, FOR_THE_HOME);
  }
}
