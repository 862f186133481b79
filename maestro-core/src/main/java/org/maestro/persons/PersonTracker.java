package org.maestro.persons;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneId;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.PersonTracking;
import org.maestro.persons.belief.Evidence;
import org.maestro.persons.belief.Whereabouts;
import org.maestro.rats.time.Clock;

/**
 * Follows all persons of a home through all of its rooms, by whatever notices them, and tells the
 * collective knowledge where each probably is (ADE, 1 and 5; A2, A74). What it tells it is never
 * wholly sure of, so that whoever has seen somebody with certainty goes before it. Confined to one
 * thread but for {@link #concerns}.
 */
public final class PersonTracker {
  /** As often it looks in any case, for what devices go on to say, and for the time that passes. */
  public static final Duration BETWEEN_LOOKS = Duration.ofSeconds(10);

  private final String agent;
  private final KnowledgeBase knowledge;
  private final Clock clock;
  private final CueWatch watch;
  private final Stays stays;
  private final ToldBeliefs told;
  private volatile Optional<Setting> setting = Optional.empty();
  private Optional<Whereabouts> whereabouts = Optional.empty();
  private Instant lastLook = Instant.MIN;

  /**
   * A tracker that knows nothing yet.
   *
   * @param agent as which source it tells what it believes
   * @param log remembers who went where
   */
  public PersonTracker(String agent, KnowledgeBase knowledge, Clock clock, HabitLog log) {
    this.agent = agent;
    this.knowledge = knowledge;
    this.clock = clock;
    this.watch = new CueWatch(agent);
    this.stays = new Stays(log);
    this.told = new ToldBeliefs();
  }

  /** Takes up what was counted before; to be called once, before it looks. */
  public void begin() {
    stays.begin(clock.instant());
    look();
  }

  /** Whether a cue may be among what has changed. Any thread may ask. */
  public boolean concerns(KnowledgeBase.Change change) {
    return !change.source().agent().equals(agent)
        && setting.map(now -> speaksOf(now.words(), change.facts())).orElse(true);
  }

  private static boolean speaksOf(Set<String> words, Collection<String> facts) {
    return facts.isEmpty() || facts.stream().anyMatch(fact -> words.contains(predicate(fact)));
  }

  private static String predicate(String fact) {
    return fact.replaceFirst("^\\((?:(?:not|unknown)\\s*\\()?", "").split("[\\s)]", 2)[0];
  }

  /** Takes in what is new, and tells what is to be believed now. */
  public void look() {
    Home home = knowledge.home();
    Snapshot facts = knowledge.snapshot();
    home.tracking().ifPresent(tracking -> look(settingOf(home, tracking, facts), facts));
  }

  private void look(Setting now, Snapshot facts) {
    Instant at = facts.at();
    Whereabouts believed = whereabouts.orElseThrow();
    if (lastLook.isAfter(Instant.MIN)) {
      believed = believed.after(Duration.between(lastLook, at));
    }
    lastLook = at;
    for (Evidence evidence : watch.news(now.sites(), facts)) {
      believed = believed.given(evidence);
    }
    whereabouts = Optional.of(believed);
    for (String person : now.persons()) {
      stays.note(person, believed.likeliest(person), now.tracking().habits().passage(), at);
    }
    tell(now, believed, at);
  }

  private void tell(Setting now, Whereabouts believed, Instant at) {
    ZoneId zone = now.home().timeZone().orElseGet(ZoneId::systemDefault);
    Map<String, Double> beliefs =
        new Beliefs(now, believed)
            .all(
                person ->
                    stays.heading(person, believed.likeliest(person), now.places(), at, zone));
    if (told.isNews(beliefs, at)) {
      knowledge.believe(new Source(Source.Kind.OBSERVED, agent), beliefs);
    }
  }

  /** Devices come and go, and now and then a zone or a person. */
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  private Setting settingOf(Home home, PersonTracking tracking, Snapshot facts) {
    Optional<Setting> before = setting;
    if (before.isPresent() && before.get().home() == home) {
      return before.get();
    }
    Setting now = Setting.of(home, tracking, facts);
    boolean areTheSame =
        before
            .filter(old -> old.persons().equals(now.persons()))
            .filter(old -> old.places().areThoseOf(now.places()))
            .isPresent();
    if (!areTheSame) {
      stays.retain(now.places());
      whereabouts =
          Optional.of(
              whereabouts
                  .map(old -> old.of(now.persons(), now.movement()))
                  .orElseGet(
                      () ->
                          Whereabouts.unknown(
                              now.persons(),
                              now.movement(),
                              tracking.habits().guestShare(),
                              tracking.habits().absence())));
    }
    setting = Optional.of(now);
    return now;
  }

  /** What it believes of each person at its last look; empty before the first. */
  public Map<String, Whereabouts.Likely> likeliest() {
    return whereabouts
        .map(
            all ->
                all.persons().stream()
                    .collect(
                        Collectors.toMap(
                            person -> person,
                            all::likeliest,
                            (one, other) -> one,
                            LinkedHashMap::new)))
        .orElseGet(LinkedHashMap::new);
  }
}
