package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** How a home says that its persons are followed, and by what. */
class PersonTrackingTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://example.org/home#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .

      <https://example.org/home> a maestro:Home ; rdfs:label "a flat" .
      home:hall a maestro:Room , maestro:Zone ; rdfs:label "the hall" ; maestro:outline "0 0, 4 0, 4 4, 0 4" .
      home:Dave a :Adult ; rdfs:label "Dave" ; :colour "blue" ; :size "0.5 0.5 1.8" .
      home:persons a :FamilyTracker ; rdfs:label "the tracker" ; maestro:wayOut home:hall .
      """;

  private static Home load(String text) {
    return new HomeLoader().load(text, "flat.ttl");
  }

  private static PersonTracking tracking(String text) {
    return load(text).tracking().orElseThrow();
  }

  private static Formula formula(String text) {
    return SlParser.formula(text);
  }

  @Test
  void aHomeWithoutATrackerFollowsNobody() {
    assertThat(load(HOME.replaceAll("home:persons .*", "")).tracking()).isEmpty();
  }

  @Test
  void theTrackerOfAFamilyHasWhatItsClassSays() {
    PersonTracking tracking = tracking(HOME);

    assertThat(tracking.agent()).isEqualTo("persons");
    assertThat(tracking.tracked()).isEqualTo("Person");
    assertThat(tracking.waysOut()).containsExactly("hall");
    assertThat(tracking.words().is()).isEqualTo(formula("(in ?person ?zone)"));
    assertThat(tracking.cues())
        .extracting(PersonCue::of)
        .contains("in", "heardIn", "PresenceSensor", "RecognisingCamera", "PhoneReceiver");
    assertThat(tracking.heard("Dave", "hall"))
        .contains((Formula.Atom) formula("(heardIn Dave hall)"));
  }

  @Test
  void whatTheHomeSaysOfItsTrackerGoesBeforeItsClass() {
    PersonTracking tracking =
        tracking(
            HOME.replace(
                "maestro:wayOut home:hall",
                "maestro:staysFor \"PT5M\"^^xsd:duration ; maestro:sureFrom 0.8"));

    assertThat(tracking.habits().stay()).isEqualTo(Duration.ofMinutes(5));
    assertThat(tracking.sureFrom()).isEqualTo(0.8);
    assertThat(tracking.waysOut()).isEmpty();
  }

  @Test
  void cuesOfDevicesOfOnesOwnCount() {
    PersonTracking tracking =
        tracking(
            HOME
                + """
                home:Mat a <http://www.w3.org/2002/07/owl#Class> ; rdfs:subClassOf :PresenceSensor ; rdfs:label "mat" ;
                  maestro:cue [ maestro:fact "(presence ?self)" ; maestro:hitRate 0.8 ; maestro:falseRate 0.01 ] .
                """);

    assertThat(tracking.cues())
        .filteredOn(cue -> cue.of().equals("Mat"))
        .singleElement()
        .satisfies(
            cue -> {
              assertThat(cue.isOfDevices()).isTrue();
              assertThat(cue.namesThePerson()).isFalse();
              assertThat(cue.hitRate()).isEqualTo(0.8);
            });
  }

  @Test
  void aQuestionOfWhereSomebodyIsCanBeAskedOfWhereSheProbablyIs() {
    PersonTracking tracking = tracking(HOME);

    assertThat(tracking.supposed(formula("(in Dave ?where)")))
        .contains(formula("(probablyIn Dave ?where)"));
    assertThat(tracking.supposed(formula("(and (Child ?x) (in ?x ?where))")))
        .contains(formula("(and (Child ?x) (probablyIn ?x ?where))"));
    assertThat(tracking.supposed(formula("(not (in Dave hall))"))).isEqualTo(Optional.empty());
    assertThat(tracking.supposed(formula("(open door)"))).isEqualTo(Optional.empty());
  }

  @Test
  void faultsAreNamedWithTheirCures() {
    assertFault("maestro:sureFrom 1.5", "is no probability from 0.5 to 1");
    assertFault("maestro:staysFor \"PT0S\"^^xsd:duration", "leaves no time");
    assertFault("maestro:tells \"(not (in ?person ?zone))\"", "is no plain fact");
    assertFault("maestro:tells \"(inn ?person ?zone)\"", "inn");
    assertFault("maestro:wayOut home:Dave", "Dave is no zone");
    assertThatThrownBy(
            () -> load(HOME + "home:others a :FamilyTracker ; rdfs:label \"another\" .\n"))
        .hasMessageContaining("is a second person tracker");
    assertCue("maestro:fact \"(presence ?self)\" ; maestro:hitRate 0.8", "has no maestro:hitRate");
    assertCue("maestro:hitRate 0.8 ; maestro:falseRate 0.1", "has no plain fact");
    assertCue(
        "maestro:fact \"(presence ?it)\" ; maestro:hitRate 0.8 ; maestro:falseRate 0.1",
        "does not tell of whom or where it speaks");
  }

  private static void assertFault(String stated, String problem) {
    assertThatThrownBy(() -> load(HOME.replace("maestro:wayOut home:hall", stated)))
        .hasMessageContaining(problem);
  }

  private static void assertCue(String cue, String problem) {
    assertThatThrownBy(
            () ->
                load(
                    HOME
                        + "home:Mat a <http://www.w3.org/2002/07/owl#Class> ; rdfs:subClassOf"
                        + " :PresenceSensor ; rdfs:label \"mat\" ; maestro:cue [ "
                        + cue
                        + " ] .\n"))
        .hasMessageContaining(problem);
  }
}
