package org.maestro.persons;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PersonTracking;
import org.maestro.persons.belief.Movement;
import org.maestro.persons.belief.Places;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * What of a home matters to following its persons, as it is at the time. Immutable.
 *
 * @param words the predicates by which cues are told
 */
record Setting(
    Home home,
    PersonTracking tracking,
    List<String> persons,
    Places places,
    List<CueSite> sites,
    Set<String> words) {
  private static final String ZONE = "Zone";

  static Setting of(Home home, PersonTracking tracking, Snapshot facts) {
    List<String> persons = names(facts, tracking.tracked());
    List<String> zones = names(facts, ZONE);
    Evaluation evaluation = new Evaluation(facts);
    Places places =
        Places.of(
            zones,
            (a, b) ->
                evaluation.truth(
                        tracking.ways(), Map.of("a", new Term.Name(a), "b", new Term.Name(b)))
                    == Truth.TRUE,
            tracking.waysOut());
    return new Setting(
        home,
        tracking,
        persons,
        places,
        new CueSites(home, facts, persons, zones).of(tracking),
        tracking.cues().stream()
            .map(cue -> cue.fact().predicate())
            .collect(Collectors.toUnmodifiableSet()));
  }

  private static List<String> names(Snapshot facts, String className) {
    return facts.individuals(className).stream().map(Term.Name::text).toList();
  }

  Movement movement() {
    return new Movement(places, tracking.habits().stay(), tracking.habits().absence());
  }
}
