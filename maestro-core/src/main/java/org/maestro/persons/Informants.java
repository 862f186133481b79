package org.maestro.persons;

import java.util.Collections;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PersonTracking;

/**
 * The sources on whose word a tracker of persons draws at a moment (ADE, 5; A74): those that have
 * told a cue which is still known. Who has left, or has said nothing for long, is none of them.
 */
public final class Informants {
  private Informants() {}

  /** The zones of whose persons each of them tells, by its name as a source. */
  public static SortedMap<String, SortedSet<String>> of(
      Home home, PersonTracking tracking, Snapshot facts) {
    SortedMap<String, SortedSet<String>> zonesBySource = new TreeMap<>();
    CueWatch watch = new CueWatch(tracking.agent());
    for (CueSite site : Setting.of(home, tracking, facts).sites()) {
      watch
          .told(site, facts)
          .ifPresent(
              told ->
                  zonesBySource
                      .computeIfAbsent(told.source().agent(), source -> new TreeSet<>())
                      .add(site.zone()));
    }
    return Collections.unmodifiableSortedMap(zonesBySource);
  }
}
