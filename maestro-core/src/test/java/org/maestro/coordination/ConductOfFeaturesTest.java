package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher.Report;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** What features say of how often they work, how often they may be tried, and what has to hold. */
class ConductOfFeaturesTest {

  /** A picker that works by chance, a porter that is counted on, and a drier with a door. */
  private static final String DEVICES =
      """

      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      :packed a maestro:Predicate, maestro:Observable ; rdfs:label "packed"@en ;
        maestro:arguments ( "?d - Device" ) .
      :shut a maestro:Predicate, maestro:Observable ; rdfs:label "shut"@en ;
        maestro:arguments ( "?d - Device" ) .
      :wrap a maestro:Task ; maestro:order 700 ; maestro:sentence "{self} packs {box}" ;
        maestro:input [ maestro:name "box" ; maestro:type :Box ] ;
        maestro:effect "(packed ?box)" ; maestro:cost "2" ; maestro:seconds "1" PICK .
      :fill a maestro:Task ; maestro:order 701 ; maestro:sentence "{self} fills {box}" ;
        maestro:input [ maestro:name "box" ; maestro:type :Box ] ;
        maestro:effect "(packed ?box)" ; maestro:cost "CARRY" ; maestro:seconds "1" .
      :dry a maestro:Task ; maestro:order 702 ; maestro:sentence "{self} dries" ;
        maestro:effect "(packed ?self)" ; maestro:cost "1" ; maestro:seconds "10" ;
        maestro:meanwhile "(shut ?self)" .
      :lying a maestro:Predicate, owl:FunctionalProperty ; rdfs:label "lying at"@en ;
        maestro:arguments ( "?d - Device" "?at - Device" ) .
      :cleared a maestro:Predicate ; rdfs:label "cleared"@en ; maestro:arguments ( "?d - Device" ) .
      :clear a maestro:Task ; maestro:order 703 ; maestro:sentence "{self} clears {box}" ;
        maestro:input [ maestro:name "box" ; maestro:type :Box ] ;
        maestro:precondition "(lying ?box picker-1)" ;
        maestro:effect "(and (cleared ?box) (not (lying ?box picker-1)))" ; maestro:cost "1" ;
        maestro:seconds "1" .
      :Box a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "box"@en .
      :Picker a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "picker"@en ; maestro:offers :wrap .
      :Porter a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "porter"@en ; maestro:offers :fill, :clear .
      :Drier a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "drier"@en ; maestro:offers :dry .
      <#picker-1> a :Picker .
      <#porter-1> a :Porter .
      <#drier-1> a :Drier .
      <#box-1> a :Box .
      """;

  private final AtomicInteger picks = new AtomicInteger();

  private PretendHouse house(String pick, String priceOfCarrying, int worksAt) {
    try (InputStream turtle = ConductOfFeaturesTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      PretendHouse house =
          new PretendHouse(
              new HomeLoader()
                  .load(
                      bob + DEVICES.replace("PICK", pick).replace("CARRY", priceOfCarrying),
                      "bob.ttl"));
      house.made.put(
          "wrap picker-1",
          step ->
              picks.incrementAndGet() < worksAt
                  ? new Report(false, Map.of(), Optional.of("It slipped."), List.of())
                  : PretendHouse.succeeded(Map.of()));
      house.made.put("fill porter-1", step -> PretendHouse.succeeded(Map.of()));
      house.made.put(
          "dry drier-1",
          step ->
              house.cancelled.isEmpty()
                  ? PretendHouse.succeeded(Map.of())
                  : new Report(false, Map.of(), Optional.of("It was ended."), List.of()));
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aPlanPricesTheCallsThatItTakesInTheMean() {
    // 2 / 0.5 is 4.
    assertThat(chosen("; maestro:chance 0.5", "4.1")).isEqualTo("wrap picker-1");
    assertThat(chosen("; maestro:chance 0.5", "3.9")).isEqualTo("fill porter-1");
    assertThat(chosen("", "3.9")).isEqualTo("wrap picker-1");
  }

  private String chosen(String pick, String priceOfCarrying) {
    PretendHouse house = house(pick, priceOfCarrying, 0);
    assertThat(house.achieve("(packed box-1)").reached())
        .as(String.join("\n", house.story))
        .isTrue();
    return house.calls.get(0);
  }

  @Test
  void whatWorksByChanceIsTriedSoOftenThatAllFailOnceInAHundredTimes() {
    // 0.7 to the power of 13 is below 0.01, to the power of 12 it is not; the last try is kept for
    // when there is nobody else.
    PretendHouse house = house("; maestro:chance 0.3", "1000", 12);

    GoalOutcome outcome = house.achieve("(packed box-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).hasSize(12).containsOnly("wrap picker-1");
  }

  @Test
  void whatMayNotBeTriedAgainIsNot() {
    PretendHouse house = house("; maestro:tries 1", "1000", 2);

    GoalOutcome outcome = house.achieve("(packed box-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).containsExactly("wrap picker-1", "fill porter-1");
  }

  /** Its doer says that it is packed, and somebody else that it is not. */
  @Test
  void norIsItWhenItWasSaidToBeDoneAndIsNot() {
    PretendHouse house = house("; maestro:tries 1", "1000", 0);
    house.made.put("fill porter-1", step -> PretendHouse.succeeded(Map.of()));
    house.clock.schedule(
        Duration.ofMillis(530),
        "porter-1",
        () ->
            house.knowledge.state(
                new Source(Source.Kind.OBSERVED, "porter-1"), List.of("(not (packed box-1))")));

    house.achieve("(packed box-1)");

    assertThat(house.calls)
        .as(String.join("\n", house.story))
        .containsOnlyOnce("wrap picker-1")
        .contains("fill porter-1");
  }

  /** Who was lost after it had cleared the box told nobody. */
  @Test
  void whatNobodyHasSaidToBeSoIsNotSeenNotToBeSo() {
    PretendHouse house = house("", "1", 0);

    GoalOutcome outcome = house.achieve("(not (cleared box-1))");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(house.calls).isEmpty();
  }

  @Test
  void norWhileTheGoalIsKept() {
    PretendHouse house = house("; maestro:tries 1", "1000", Integer.MAX_VALUE);
    house.made.put(
        "fill porter-1",
        step -> new Report(false, Map.of(), Optional.of("It is empty."), List.of()));

    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(keep (packed box-1))"), "Bob"), outcome -> {});
    house.clock.run(Duration.ofMinutes(5));

    assertThat(house.calls)
        .as(String.join("\n", house.story))
        .containsOnlyOnce("wrap picker-1")
        .contains("fill porter-1");
  }

  /** Where the box lies now nobody knows, and nobody can see it. */
  @Test
  void whatAFailureLeftOpenIsNoProof() {
    PretendHouse house = house("", "1", 0);
    house.knowledge.state(
        new Source(Source.Kind.STATED, "box-1"), List.of("(lying box-1 picker-1)"));
    house.made.put(
        "clear porter-1",
        step -> new Report(false, Map.of(), Optional.of("It gave no answer."), List.of()));

    GoalOutcome outcome = house.achieve("(cleared box-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isFalse();
    assertThat(house.calls).containsOnly("clear porter-1");
    assertThat(outcome.reasons())
        .as(String.join("\n", house.story))
        .anyMatch(reason -> reason.startsWith("It is not known that box-1 is lying at picker-1"))
        .anyMatch(reason -> reason.contains("not proven"));
  }

  @Test
  void aStepIsEndedWhenWhatHasToHoldMeanwhileDoesNotAnyMore() {
    PretendHouse house = house("", "1", 0);
    shut(house, true);
    house.stepTakes = Duration.ofSeconds(10);
    house.clock.schedule(Duration.ofSeconds(4), "drier-1", () -> shut(house, false));

    GoalOutcome outcome = house.achieve("(packed drier-1)");

    assertThat(outcome.reached()).isFalse();
    assertThat(house.cancelled).as(String.join("\n", house.story)).containsExactly("dry drier-1");
    assertThat(house.story)
        .as(String.join("\n", house.story))
        .anyMatch(
            told ->
                told.contains(
                    "drier-1 was ended in dry, as it has to hold meanwhile that (shut drier-1), and"
                        + " it did not any more"));
  }

  @Test
  void itIsNotBegunBeforeItHolds() {
    PretendHouse house = house("", "1", 0);
    shut(house, false);

    GoalOutcome outcome = house.achieve("(packed drier-1)");

    assertThat(outcome.reached()).isFalse();
    assertThat(house.calls).isEmpty();
  }

  private static void shut(PretendHouse house, boolean isShut) {
    house.knowledge.state(
        new Source(Source.Kind.STATED, "drier-1"),
        List.of(isShut ? "(shut drier-1)" : "(not (shut drier-1))"));
  }
}
