package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlParser;

/** What is so only as long as a device goes on with it. */
class ContinuousEffectTest {

  private static final String LIFT =
      """

      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      :moving a maestro:Predicate, maestro:Observable ; rdfs:label "moving"@en ;
        maestro:arguments ( "?l - Device" ) .
      :above a maestro:Predicate, maestro:Observable ; rdfs:label "above"@en ;
        maestro:arguments ( "?l - Device" ) .
      :run a maestro:Task ; maestro:order 700 ; maestro:sentence "{self} runs" ;
        maestro:effect "(moving ?self)" ; maestro:cost "1" ; maestro:seconds "1" ;
        maestro:continuous true .
      :ride a maestro:Task ; maestro:order 701 ; maestro:sentence "{self} rides" ;
        maestro:precondition "(moving lift-1)" ; maestro:effect "(above ?self)" ;
        maestro:cost "1" ; maestro:seconds "1" .
      :Lift a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "lift"@en ; maestro:offers :run .
      :Rider a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "rider"@en ; maestro:offers :ride .
      <#lift-1> a :Lift .
      <#rider-1> a :Rider .
      """;

  private final PretendHouse house = house();

  private static PretendHouse house() {
    try (InputStream turtle = ContinuousEffectTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      PretendHouse house = new PretendHouse(new HomeLoader().load(bob + LIFT, "bob.ttl"));
      house.made.put("run lift-1", step -> PretendHouse.succeeded(Map.of()));
      house.made.put("ride rider-1", step -> PretendHouse.succeeded(Map.of()));
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void whatIsReachedIsNotEndedByTheEndOfItsGoal() {
    assertThat(house.achieve("(moving lift-1)").reached()).isTrue();

    assertThat(house.calls).containsExactly("run lift-1");
    assertThat(house.cancelled).isEmpty();
  }

  @Test
  void whatWasOnlyNeededOnTheWayIsEndedWithTheGoal() {
    house.beforeCall =
        call -> assertThat(house.cancelled).as("it goes on while it is needed").isEmpty();

    assertThat(house.achieve("(above rider-1)").reached()).isTrue();

    assertThat(house.calls).containsExactly("run lift-1", "ride rider-1");
    assertThat(house.cancelled).containsExactly("run lift-1");
  }

  @Test
  void whatIsKeptGoesOnUntilItIsNotKeptAnyMore() {
    List<GoalOutcome> ended = new ArrayList<>();
    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(keep (moving lift-1))"), "Bob"), ended::add);
    house.clock.runUntil(
        () -> house.story.stream().anyMatch(told -> told.contains("is kept so")),
        Duration.ofMinutes(1));
    assertThat(house.cancelled).isEmpty();

    house.coordinator.cancel("G1", "Bob");
    house.clock.runUntil(() -> !ended.isEmpty(), Duration.ofMinutes(1));

    assertThat(house.cancelled).containsExactly("run lift-1");
  }

  /** Nothing is so by a call that nobody has taken up; and none of them is left behind. */
  @Test
  void whoNeverTellsThatItIsSoHasFailedAndIsCalledOff() {
    List<ActionDispatcher.Request> ending = new ArrayList<>();
    house.coordinator.memberPresent("lift-1", Optional.of("its life"));
    house.ordered =
        order -> {
          if (order.ends()) {
            ending.add(order);
          }
        };
    house.reporting =
        (step, report) ->
            new ActionDispatcher.Report(
                false,
                Map.of(),
                Optional.of("lift-1 gave no answer in time"),
                List.of(),
                true,
                Optional.empty(),
                true);

    assertThat(house.achieve("(moving lift-1)").reached()).isFalse();

    assertThat(house.calls).hasSizeGreaterThan(1).containsOnly("run lift-1");
    assertThat(ending).as("each that was begun").hasSize(house.calls.size() / 2);
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "what is continuous has to tell by progress ESTABLISHED that its effect is"
                        + " there"));
  }
}
