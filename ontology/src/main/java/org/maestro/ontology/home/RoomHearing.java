package org.maestro.ontology.home;

import java.util.Collections;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;

/**
 * What a room agent hears, and of what it knows the words (ADE, 5; A13, A71).
 *
 * @param rooms in which what is said is heard by it
 * @param topics names of topics and of constructions; none: it passes all on
 * @param persona the name under which it speaks
 */
public record RoomHearing(Set<String> rooms, Set<String> topics, Optional<String> persona) {
  public RoomHearing {
    rooms = Collections.unmodifiableSet(new TreeSet<>(rooms));
    topics = Collections.unmodifiableSet(new TreeSet<>(topics));
  }
}
