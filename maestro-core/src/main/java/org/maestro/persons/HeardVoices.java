package org.maestro.persons;

import java.util.List;
import java.util.Optional;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.sl.SlPrinter;

/**
 * Tells the collective knowledge who was heard to speak where, if the home counts that as a cue.
 */
public final class HeardVoices {
  private static final String ZONE = "Zone";

  private final KnowledgeBase knowledge;

  public HeardVoices(KnowledgeBase knowledge) {
    this.knowledge = knowledge;
  }

  /**
   * Somebody has spoken. Any thread may call.
   *
   * @param room where; empty when nobody knows
   */
  public void heard(String person, String room) {
    Home home = knowledge.home();
    Optional.ofNullable(home.individuals().get(room))
        .filter(place -> place.classes().contains(ZONE))
        .flatMap(place -> home.tracking())
        .flatMap(tracking -> tracking.heard(person, room))
        .ifPresent(
            fact ->
                knowledge.state(
                    new Source(Source.Kind.OBSERVED, room), List.of(SlPrinter.print(fact))));
  }
}
