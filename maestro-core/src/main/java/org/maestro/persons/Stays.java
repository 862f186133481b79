package org.maestro.persons;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.persons.belief.Places;
import org.maestro.persons.belief.Whereabouts;
import org.maestro.persons.visits.Passage;
import org.maestro.persons.visits.Passages;

/**
 * Which person has come to which place, from where and when, as far as that is believed; and where
 * she is heading. Confined to one thread.
 */
final class Stays {
  /** A place that is likelier than any other is where somebody has come to. */
  private static final double BELIEVED = 0.5;

  private final Passages passages;
  private final Map<String, Visit> byPerson = new TreeMap<>();

  /**
   * Somebody's stay in a place.
   *
   * @param over whether it was counted what she did there
   */
  private record Visit(String from, String place, Instant since, boolean over) {}

  Stays(HabitLog log) {
    this.passages = new Passages(log);
  }

  void begin(Instant now) {
    passages.begin(now);
  }

  /**
   * Notes where somebody is believed to be now.
   *
   * @param passage who has not gone on by then stays
   */
  void note(String person, Whereabouts.Likely likeliest, Duration passage, Instant now) {
    if (likeliest.probability() <= BELIEVED) {
      return;
    }
    Visit before = byPerson.get(person);
    if (before == null) {
      byPerson.put(person, new Visit(likeliest.place(), likeliest.place(), now, true));
    } else if (!before.place().equals(likeliest.place())) {
      count(person, before, likeliest.place(), now);
      byPerson.put(person, new Visit(before.place(), likeliest.place(), now, false));
    } else if (!before.over() && before.since().plus(passage).isBefore(now)) {
      count(person, before, before.place(), now);
      byPerson.put(person, new Visit(before.from(), before.place(), before.since(), true));
    }
  }

  private void count(String person, Visit visit, String next, Instant now) {
    if (!visit.over()) {
      passages.add(new Passage(now, person, visit.from(), visit.place(), next));
    }
  }

  /**
   * Where she is heading who has just come somewhere, and how likely; empty when nobody can tell.
   */
  Optional<Passages.Next> heading(
      String person, Whereabouts.Likely likeliest, Places places, Instant now, ZoneId zone) {
    return Optional.ofNullable(byPerson.get(person))
        .filter(visit -> !visit.over() && visit.place().equals(likeliest.place()))
        .flatMap(
            visit ->
                passages.next(
                    person, visit.from(), visit.place(), places.waysFrom(visit.place()), now, zone))
        .map(next -> new Passages.Next(next.place(), next.probability() * likeliest.probability()));
  }

  /** Who is no longer followed is forgotten, as are places that are none any more. */
  void retain(Places places) {
    byPerson.values().removeIf(visit -> !places.has(visit.place()) || !places.has(visit.from()));
  }
}
