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
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;

/** What nobody can see is asked of those once more who have told of it, before it is claimed. */
class SpeakersTest {

  private static final String VENTS =
      """

      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      :ajar a maestro:Predicate, maestro:Observable ; rdfs:label "ajar"@en ;
        maestro:arguments ( "?v - Vent" ) .
      :open a maestro:Task ; maestro:order 700 ; maestro:sentence "{self} opens" ;
        maestro:effect "(ajar ?self)" ; maestro:cost "2" ; maestro:seconds "1" .
      :openAll a maestro:Task ; maestro:order 701 ; maestro:sentence "{self} opens {vent}" ;
        maestro:input [ maestro:name "vent" ; maestro:type :Vent ] ;
        maestro:effect "(ajar ?vent)" ; maestro:cost "1" ; maestro:seconds "1" .
      :Vent a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "vent"@en ; maestro:offers :open .
      :Centre a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "centre"@en ;
        maestro:offers :openAll .
      <#vent-1> a :Vent .
      """;

  private final List<String> asked = new ArrayList<>();

  private PretendHouse house(String more) {
    try (InputStream turtle = SpeakersTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      PretendHouse house = new PretendHouse(new HomeLoader().load(bob + VENTS + more, "bob.ttl"));
      house.made.put("open vent-1", step -> PretendHouse.succeeded(Map.of()));
      house.made.put("openAll centre-1", step -> PretendHouse.succeeded(Map.of()));
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void tells(PretendHouse house, boolean isAjar) {
    house.knowledge.state(
        new Source(Source.Kind.STATED, "vent-1"),
        List.of(isAjar ? "(ajar vent-1)" : "(not (ajar vent-1))"));
  }

  @Test
  void whoReportsADeedAndThenDeniesItIsNotBelieved() {
    PretendHouse house = house("");
    tells(house, false);
    house.whenAsked = member -> tells(house, false);

    GoalOutcome outcome = house.achieve("(ajar vent-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isFalse();
    assertThat(house.story)
        .anyMatch(told -> told.contains("vent-1 was asked once more, and the goal is not reached"))
        .noneMatch(told -> told.contains("as far as vent-1 says"));
  }

  @Test
  void whoGoesOnSayingSoIs() {
    PretendHouse house = house("");
    house.whenAsked =
        member -> {
          asked.add(member);
          tells(house, true);
        };

    GoalOutcome outcome = house.achieve("(ajar vent-1)");

    assertThat(outcome.reached()).isTrue();
    assertThat(outcome.confirmed()).isFalse();
    assertThat(outcome.reasons())
        .containsExactly("It is done, as far as vent-1 says; nobody can confirm it.");
    assertThat(asked).containsExactly("vent-1");
    assertThat(house.calls).containsExactly("open vent-1");
  }

  @Test
  void whatItSaysOfItselfCountsAgainstWhoSaysThatItDidIt() {
    PretendHouse house = house("<#centre-1> a :Centre .");
    tells(house, false);
    boolean[] isAjar = new boolean[1];
    house.beforeCall = call -> isAjar[0] |= call.equals("open vent-1");
    house.whenAsked =
        member -> {
          if (member.equals("vent-1")) {
            tells(house, isAjar[0]);
          }
        };

    GoalOutcome outcome = house.achieve("(ajar vent-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).startsWith("openAll centre-1").endsWith("open vent-1");
  }

  /** What was there for a while is not told to have been nothing. */
  @Test
  void whatComesAndGoesIsToldSo() {
    PretendHouse house = house("");
    tells(house, false);
    house.beforeCall =
        call -> {
          tells(house, true);
          house.clock.schedule(Duration.ofMillis(50), "wind", () -> tells(house, false));
        };

    GoalOutcome outcome = house.achieve("(ajar vent-1)");

    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains("times that it had done open, and what had come of it was gone when"))
        .noneMatch(told -> told.contains("nothing had changed"));
    assertThat(outcome.reached()).isFalse();
  }
}
