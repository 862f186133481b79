package org.maestro.persons;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.ontology.home.PersonCue;
import org.maestro.ontology.home.PersonTracking;
import org.maestro.persons.belief.Places;
import org.maestro.persons.belief.Whereabouts;
import org.maestro.persons.visits.Passages;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/** What is told of whereabouts, in the words of the home, each fact with how likely it is. */
final class Beliefs {
  /** Less likely things are told of nobody: something else is as likely. */
  private static final double LIKELIER_THAN_NOT = 0.5;

  /** Nothing that is concluded is certain. */
  private static final double MOST = 0.99;

  private final Setting setting;
  private final Whereabouts whereabouts;
  private final Map<String, Double> beliefs = new LinkedHashMap<>();

  Beliefs(Setting setting, Whereabouts whereabouts) {
    this.setting = setting;
    this.whereabouts = whereabouts;
  }

  /**
   * All that is to be told.
   *
   * @param heading where each person is heading
   */
  Map<String, Double> all(Function<String, Optional<Passages.Next>> heading) {
    PersonTracking tracking = setting.tracking();
    for (String person : setting.persons()) {
      Whereabouts.Likely likeliest = whereabouts.likeliest(person);
      if (!likeliest.isAway() && likeliest.probability() > LIKELIER_THAN_NOT) {
        tracking
            .words()
            .probablyIs()
            .ifPresent(word -> add(word, person, likeliest.place(), likeliest.probability()));
        if (likeliest.probability() >= tracking.sureFrom()) {
          add(tracking.words().is(), person, likeliest.place(), likeliest.probability());
        }
      }
      heading
          .apply(person)
          .filter(next -> next.probability() >= tracking.foretellsFrom())
          .filter(next -> !next.place().equals(Places.AWAY))
          .ifPresent(
              next ->
                  tracking
                      .words()
                      .heading()
                      .ifPresent(word -> add(word, person, next.place(), next.probability())));
    }
    tracking.words().guest().ifPresent(this::addGuests);
    return beliefs;
  }

  private void addGuests(Formula.Atom word) {
    for (String place : setting.places().names()) {
      double probability = whereabouts.guest(place);
      if (!place.equals(Places.AWAY) && probability > LIKELIER_THAN_NOT) {
        add(word, Map.of(PersonCue.ZONE, new Term.Name(place)), probability);
      }
    }
  }

  private void add(Formula.Atom word, String person, String zone, double probability) {
    add(
        word,
        Map.of(PersonCue.PERSON, new Term.Name(person), PersonCue.ZONE, new Term.Name(zone)),
        probability);
  }

  private void add(Formula.Atom word, Map<String, Term> names, double probability) {
    beliefs.put(SlPrinter.print(new Substitution(names).apply(word)), Math.min(MOST, probability));
  }
}
