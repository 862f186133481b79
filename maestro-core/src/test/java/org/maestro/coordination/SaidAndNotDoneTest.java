package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.HomeLoader;

/** A pump says that it waters the tree, and the tree stays dry; it is not asked for ever. */
class SaidAndNotDoneTest {

  private static final String PUMP =
      """

      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
      :Tree a owl:Class ; rdfs:subClassOf maestro:Thing ; rdfs:label "tree"@en .
      :wetness a maestro:Fluent, maestro:Observable ; rdfs:label "wetness"@en ; maestro:least 0 ;
        maestro:arguments ( "?t - Tree" ) .
      :water a maestro:Task ; maestro:order 700 ; maestro:sentence "{self} waters {tree}" ;
        maestro:input [ maestro:name "tree" ; maestro:type :Tree ] ,
          [ maestro:name "amount" ; maestro:type xsd:decimal ; maestro:oneOf ( 0.1 0.2 0.5 ) ] ;
        maestro:precondition "(<= (wetness ?tree) 1)" ;
        maestro:effect "(increase (wetness ?tree) ?amount)" ;
        maestro:cost "(* 10 ?amount)" ; maestro:seconds "1" ; maestro:occupies ( "pump" ) .
      :Pump a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "pump"@en ; maestro:offers :water .
      <#pump-1> a :Pump .
      <#oak> a :Tree ; rdfs:label "oak"@en .
      <#elm> a :Tree ; rdfs:label "elm"@en .
      """;

  private static PretendHouse house() {
    return house(PUMP);
  }

  private static PretendHouse house(String pump) {
    try (InputStream turtle = SaidAndNotDoneTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      PretendHouse house = new PretendHouse(new HomeLoader().load(bob + pump, "bob.ttl"));
      house.made.put("water pump-1", step -> PretendHouse.succeeded(Map.of()));
      tell(house, 0.2);
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void tell(PretendHouse house, double wetnessOfTheOak) {
    house.knowledge.state(
        new Source(Source.Kind.STATED, "pump-1"),
        List.of("(= (wetness oak) %s)".formatted(wetnessOfTheOak), "(= (wetness elm) 0.2)"));
  }

  /** What it tells some moments after each call. */
  private static void thenTells(PretendHouse house, DoubleSupplier wetnessOfTheOak) {
    house.beforeCall =
        call ->
            house.clock.schedule(
                Duration.ofMillis(5), "pump-1", () -> tell(house, wetnessOfTheOak.getAsDouble()));
  }

  @Test
  void itIsLeftAloneWhateverTheAmountsAndTriedOnceMore() {
    PretendHouse house = house();
    thenTells(house, () -> 0.2);

    GoalOutcome outcome = house.achieve("(>= (wetness oak) 0.6)");

    assertThat(outcome.reached()).isFalse();
    assertThat(house.calls).as(String.join("\n", house.story)).hasSize(5);
    assertThat(outcome.reasons())
        .as(outcome.reasons().toString())
        .anyMatch(
            reason ->
                reason.contains(
                    "pump-1 said 5 times that it had done water, and nothing had changed when it"
                        + " was needed again"))
        .anyMatch(reason -> reason.contains("not proven"))
        .noneMatch(reason -> reason.contains("after all (pump-1 waters oak), or if pump-1"));
  }

  /** It may well be possible, with an amount that nobody has described. */
  @Test
  void anAmountThatNoPlanCanChooseIsNamedAndNothingIsCalledImpossible() {
    PretendHouse house = house(PUMP.replace(" ; maestro:oneOf ( 0.1 0.2 0.5 )", ""));

    GoalOutcome outcome = house.achieve("(>= (wetness oak) 0.6)");

    assertThat(house.calls).isEmpty();
    assertThat(outcome.reasons())
        .contains(
            "It is not known whether pump-1 could do it by water: nothing says which values amount"
                + " may have; its description has to name them (oneOf).");
  }

  @Test
  void whatComesOfItLittleByLittleIsNotInVain() {
    PretendHouse house = house();
    AtomicInteger hundredths = new AtomicInteger(20);
    thenTells(house, () -> hundredths.addAndGet(5) / 100.0);

    GoalOutcome outcome = house.achieve("(>= (wetness oak) 0.6)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).hasSizeGreaterThan(4);
  }

  @Test
  void anotherTreeIsTriedAllTheSame() {
    PretendHouse house = house();
    thenTells(house, () -> 0.2);
    house.achieve("(>= (wetness oak) 0.6)");
    house.calls.clear();

    GoalOutcome outcome = house.achieve("(>= (wetness elm) 0.6)");

    assertThat(outcome.reached()).isFalse();
    assertThat(house.calls).hasSize(5);
  }
}
