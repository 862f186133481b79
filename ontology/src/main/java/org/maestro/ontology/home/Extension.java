package org.maestro.ontology.home;

import java.util.Collections;
import java.util.Map;
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

  public Extension {
    things = Collections.unmodifiableMap(new TreeMap<>(things));
  }
}
