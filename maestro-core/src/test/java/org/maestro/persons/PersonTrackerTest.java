package org.maestro.persons;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.habits.HabitLog;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** A hallway between the living room and the bedroom, with a radar each and one camera. */
class PersonTrackerTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://example.org/home#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .

      <https://example.org/home> a maestro:Home ; rdfs:label "a flat" .
      home:hallway a maestro:Room , maestro:Zone ; rdfs:label "the hallway" ;
        maestro:outline "0 4, 6 4, 6 6, 0 6" .
      home:livingroom a maestro:Room , maestro:Zone ; rdfs:label "the living room" ;
        maestro:outline "0 0, 6 0, 6 4, 0 4" .
      home:bedroom a maestro:Room , maestro:Zone ; rdfs:label "the bedroom" ;
        maestro:outline "0 6, 6 6, 6 9, 0 9" .
      home:living-door a maestro:Door ; rdfs:label "a door" ; :side home:livingroom , home:hallway ;
        maestro:openingFrom "2 4" ; maestro:openingTo "3 4" .
      home:bed-door a maestro:Door ; rdfs:label "a door" ; :side home:bedroom , home:hallway ;
        maestro:openingFrom "2 6" ; maestro:openingTo "3 6" .
      home:Dave a :Adult ; rdfs:label "Dave" ; :colour "blue" ; :size "0.5 0.5 1.8" .
      home:Rose a :Adult ; rdfs:label "Rose" ; :colour "red" ; :size "0.5 0.5 1.7" .
      home:persons a :FamilyTracker ; rdfs:label "the tracker" ; maestro:wayOut home:hallway .
      home:radar-hall a :PresenceSensor ; rdfs:label "a radar" ; maestro:pose "3 5 2" .
      home:radar-living a :PresenceSensor ; rdfs:label "a radar" ; maestro:pose "3 2 2" .
      home:radar-bed a :PresenceSensor ; rdfs:label "a radar" ; maestro:pose "3 8 2" .
      home:eye-hall a :RecognisingCamera ; rdfs:label "a camera" ; maestro:pose "3 5 2" .
      home:eye-living a :RecognisingCamera ; rdfs:label "a camera" ; maestro:pose "3 2 2" .
      home:cam-bed a :Camera ; rdfs:label "a camera" ; maestro:pose "3 8 2" ; maestro:viewAngle 120 ;
        :minimumIlluminance 72 ; :maximumIlluminance 2000 .
      """;

  private final Home home = new HomeLoader().load(HOME, "flat.ttl").in(ZoneOffset.UTC);
  private final SteppedClock clock = new SteppedClock();
  private final KnowledgeBase knowledge = new CollectiveKnowledge(home, clock);
  private final List<String> kept = new ArrayList<>();
  private final HabitLog log =
      new HabitLog() {
        @Override
        public List<String> lines() {
          return List.copyOf(kept);
        }

        @Override
        public void add(String line) {
          kept.add(line);
        }
      };
  private final PersonTracker tracker = begun();

  private PersonTracker begun() {
    PersonTracker begun = new PersonTracker("persons", knowledge, clock, log);
    begun.begin();
    return begun;
  }

  private void radar(String zone, boolean on) {
    String fact = "(presence radar-%s)".formatted(zone);
    states("radar-" + zone, on ? fact : "(not " + fact + ")");
  }

  /** Whom the camera sees; the others it does not. */
  private void eye(String zone, String... seen) {
    List<String> facts = new ArrayList<>();
    for (String person : List.of("Dave", "Rose")) {
      String fact = "(recognises eye-%s %s)".formatted(zone, person);
      facts.add(List.of(seen).contains(person) ? fact : "(not " + fact + ")");
    }
    states("eye-" + zone, facts.toArray(String[]::new));
  }

  private void states(String device, String... facts) {
    knowledge.state(new Source(Source.Kind.STATED, device), List.of(facts));
  }

  private void sees(String camera, String fact) {
    knowledge.state(new Source(Source.Kind.OBSERVED, camera), List.of(fact));
  }

  private void pass(int seconds) {
    for (int i = 0; i < seconds; i++) {
      clock.run(Duration.ofSeconds(1));
      tracker.look();
    }
  }

  private Optional<Belief> known(String atom) {
    Formula.Atom asked = (Formula.Atom) SlParser.formula(atom);
    return knowledge.snapshot().belief(asked).filter(belief -> belief.fact().equals(atom));
  }

  @Test
  void ofWhomNothingIsKnownNothingIsTold() {
    pass(60);

    assertThat(knowledge.snapshot().beliefs()).isEmpty();
  }

  @Test
  void whoIsSeenAndNoticedIsThereAsSurelyAsThatMakesIt() {
    eye("living", "Dave");
    radar("living", true);
    pass(15);

    Belief told = known("(in Dave livingroom)").orElseThrow();
    assertThat(told.source()).isEqualTo(new Source(Source.Kind.OBSERVED, "persons"));
    assertThat(told.confidence()).isBetween(0.9, 0.99);
    assertThat(told.age(clock.instant())).isLessThanOrEqualTo(Duration.ofSeconds(20));
    assertThat(known("(probablyIn Dave livingroom)")).isPresent();
    assertThat(known("(in Rose livingroom)")).isEmpty();
  }

  @Test
  void whatIsOnlyLikelyIsToldAsThatAndNotAsKnown() {
    eye("living", "Dave");
    pass(2);
    eye("living");
    radar("hall", true);
    pass(2);

    assertThat(known("(in Dave hallway)")).isEmpty();
    assertThat(known("(in Dave livingroom)")).isEmpty();
    known("(probablyIn Dave hallway)")
        .ifPresent(told -> assertThat(told.confidence()).isBetween(0.5, 0.9));
  }

  @Test
  void whatWasKnownIsWithdrawnWhenItIsNotSureAnyMore() {
    eye("living", "Dave");
    radar("living", true);
    pass(15);
    assertThat(known("(in Dave livingroom)")).isPresent();

    eye("living");
    radar("living", false);
    pass(2);
    assertThat(known("(in Dave livingroom)")).isEmpty();
    assertThat(known("(probablyIn Dave livingroom)")).isEmpty();
  }

  @Test
  void whatACameraHasSeenForSureIsNotOverruled() {
    sees("cam-bed", "(in Dave bedroom)");
    pass(1);
    assertThat(known("(in Dave bedroom)").orElseThrow().source().agent()).isEqualTo("cam-bed");

    eye("living", "Dave");
    radar("living", true);
    pass(20);
    assertThat(known("(in Dave bedroom)").orElseThrow().source().agent()).isEqualTo("cam-bed");
    assertThat(known("(probablyIn Dave livingroom)")).isPresent();
  }

  @Test
  void whatACameraHasSeenMattersAlsoWhenItIsTooOldToCount() {
    sees("cam-bed", "(in Dave bedroom)");
    pass(45);

    assertThat(known("(in Dave bedroom)")).isEmpty();
    assertThat(known("(probablyIn Dave bedroom)").orElseThrow().confidence()).isBetween(0.5, 0.9);
  }

  @Test
  void aVoiceTellsWhereSomebodyIs() {
    HeardVoices voices = new HeardVoices(knowledge);
    voices.heard("Rose", "bedroom");
    radar("bed", true);
    pass(1);

    assertThat(known("(heardIn Rose bedroom)")).isPresent();
    assertThat(known("(probablyIn Rose bedroom)")).isPresent();
    assertThat(known("(probablyIn Dave bedroom)")).isEmpty();
    voices.heard("Rose", "");
    voices.heard("Rose", "nowhere");
  }

  @Test
  void somebodyWhereNobodyKnownCanBeIsAGuest() {
    radar("bed", true);
    for (int i = 0; i < 30; i++) {
      eye("living", "Dave", "Rose");
      radar("living", true);
      pass(1);
    }

    assertThat(known("(guestIn bedroom)")).isPresent();
    assertThat(known("(probablyIn Dave bedroom)")).isEmpty();
    assertThat(known("(in Dave livingroom)")).isPresent();
  }

  private void evening() {
    eye("living");
    eye("hall", "Dave");
    radar("hall", true);
    radar("living", false);
    pass(5);
    eye("hall");
    eye("living", "Dave");
    radar("hall", false);
    radar("living", true);
    pass(90);
    eye("living");
    radar("living", false);
    pass(600);
  }

  @Test
  void whoWentToTheLivingRoomOnFormerEveningsIsToldToHeadThereUntilHeDoesNot() {
    for (int i = 0; i < 6; i++) {
      evening();
    }
    assertThat(kept).anyMatch(line -> line.endsWith("hallway livingroom"));
    eye("hall", "Dave");
    radar("hall", true);
    pass(3);
    Belief foretold = known("(headingTo Dave livingroom)").orElseThrow();
    assertThat(foretold.confidence()).isBetween(0.7, 0.99);
    assertThat(foretold.source().agent()).isEqualTo("persons");

    eye("hall");
    radar("hall", false);
    radar("bed", true);
    HeardVoices voices = new HeardVoices(knowledge);
    voices.heard("Dave", "bedroom");
    pass(12);
    assertThat(known("(headingTo Dave livingroom)")).isEmpty();
  }

  @Test
  void whatItTellsItselfIsNoCue() {
    eye("living", "Dave");
    radar("living", true);
    pass(10);
    eye("living");
    states("eye-living");
    states("radar-living");
    double before = tracker.likeliest().get("Dave").probability();
    pass(120);

    assertThat(tracker.likeliest().get("Dave").probability()).isLessThan(before);
  }

  @Test
  void onlyChangesThatMayBeCuesConcernIt() {
    Source other = new Source(Source.Kind.STATED, "radar-hall");
    assertThat(
            List.of(
                tracker.concerns(
                    new KnowledgeBase.Change(1, other, List.of("(presence radar-hall)"))),
                tracker.concerns(
                    new KnowledgeBase.Change(1, other, List.of("(not (presence radar-hall))"))),
                tracker.concerns(new KnowledgeBase.Change(1, other, List.of("(= (level lamp) 1)"))),
                tracker.concerns(
                    new KnowledgeBase.Change(
                        1,
                        new Source(Source.Kind.OBSERVED, "persons"),
                        List.of("(in Dave bedroom)")))))
        .containsExactly(true, true, false, false);
  }
}
