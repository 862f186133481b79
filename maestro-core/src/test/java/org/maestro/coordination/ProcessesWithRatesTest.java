package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.SlPrinter;

/**
 * An oven warms by 0.5 degrees a second and cools by 0.1; its features say so, and so plans know
 * how long each takes from where the oven is.
 */
class ProcessesWithRatesTest {

  private static final String OVEN =
      """

      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
      :warmth a maestro:Fluent, maestro:Observable ; rdfs:label "warmth"@en ;
        maestro:arguments ( "?o - Device" ) .
      :heat a maestro:Task ; maestro:order 700 ; maestro:sentence "{self} heats to {degrees}" ;
        maestro:input [ maestro:name "degrees" ; maestro:type xsd:decimal ; maestro:oneOf ( 60 120 180 ) ] ;
        maestro:precondition "(< (warmth ?self) ?degrees)" ;
        maestro:effect "(assign (warmth ?self) ?degrees)" ; maestro:cost "(- ?degrees (warmth ?self))" ;
        maestro:seconds "(/ (- ?degrees (warmth ?self)) 0.5)" ;
        maestro:doneWhen "(>= (warmth ?self) ?degrees)" ; maestro:occupies ( "oven" ) .
      :cool a maestro:Task ; maestro:order 701 ; maestro:sentence "{self} cools to {degrees}" ;
        maestro:input [ maestro:name "degrees" ; maestro:type xsd:decimal ; maestro:oneOf ( 30 40 ) ] ;
        maestro:precondition "(> (warmth ?self) ?degrees)" ;
        maestro:effect "(assign (warmth ?self) ?degrees)" ;
        maestro:cost "(/ (- (warmth ?self) ?degrees) 0.1)" ;
        maestro:doneWhen "(<= (warmth ?self) ?degrees)" ; maestro:occupies ( "oven" ) .
      :Oven a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "oven"@en ;
        maestro:offers :heat, :cool .
      <#oven-1> a :Oven .
      """;

  private final List<ActionDispatcher.Request> orders = new ArrayList<>();

  private PretendHouse house(double degrees) {
    try (InputStream turtle = ProcessesWithRatesTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      PretendHouse house = new PretendHouse(new HomeLoader().load(bob + OVEN, "bob.ttl"));
      tell(house, degrees);
      house.ordered = orders::add;
      for (String feature : List.of("heat", "cool")) {
        house.made.put(
            feature + " oven-1",
            step -> {
              tell(house, Double.parseDouble(SlPrinter.print(step.bindings().get("degrees"))));
              return PretendHouse.succeeded(Map.of());
            });
      }
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void tell(PretendHouse house, double degrees) {
    house.knowledge.state(
        new Source(Source.Kind.STATED, "oven-1"),
        List.of("(= (warmth oven-1) %s)".formatted(degrees)));
  }

  @ParameterizedTest
  @CsvSource({
    "20, (>= (warmth oven-1) 100), heat oven-1, 200",
    "90, (>= (warmth oven-1) 100), heat oven-1, 60",
    "90, (<= (warmth oven-1) 40), cool oven-1, 500"
  })
  void takeAsLongAsTheirRatesSay(double from, String goal, String call, double seconds) {
    PretendHouse house = house(from);

    GoalOutcome outcome = house.achieve(goal);

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).containsExactly(call);
    assertThat(orders.get(0).step().seconds()).isCloseTo(seconds, within(1e-9));
    assertThat(orders.get(0).timeout().toMillis())
        .isBetween((long) (3_000 * seconds), (long) (3_000 * seconds) + 20_000);
  }

  @Test
  void coolingIsReckonedFromWhereHeatingHasLed() {
    PretendHouse house = house(20);

    house.achieve("(>= (warmth oven-1) 100)");
    house.achieve("(<= (warmth oven-1) 30)");

    assertThat(house.calls)
        .as(String.join("\n", house.story))
        .contains("heat oven-1", "cool oven-1");
    assertThat(orders.get(orders.size() - 1).step().seconds()).isCloseTo(900, within(1e-9));
  }
}
