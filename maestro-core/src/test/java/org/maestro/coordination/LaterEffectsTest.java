package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** An oven answers when it begins to heat, and is hot some time later, or never. */
class LaterEffectsTest {

  private static final String OVEN =
      """

      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      :warm a maestro:Predicate, maestro:Observable ; rdfs:label "hot"@en ;
        maestro:arguments ( "?o - Device" ) .
      :heat a maestro:Task ; maestro:order 700 ; maestro:sentence "{self} heats up" ;
        maestro:effect "(warm ?self)" ; maestro:cost "2" ; maestro:seconds "1" ; TIMING .
      :Oven a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "oven"@en ; maestro:offers :heat ;
        maestro:reports [ maestro:name "warm" ; maestro:fact "(warm ?self)" ] .
      <#oven-1> a :Oven .
      """;

  private static PretendHouse house(String timing) {
    try (InputStream turtle = LaterEffectsTest.class.getResourceAsStream("/bob.ttl")) {
      String bob = new String(turtle.readAllBytes(), StandardCharsets.UTF_8);
      Home home = new HomeLoader().load(bob + OVEN.replace("TIMING", timing), "bob.ttl");
      PretendHouse house = new PretendHouse(home);
      house.made.put("heat oven-1", step -> PretendHouse.succeeded(Map.of()));
      return house;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void isHotAfter(PretendHouse house, Duration time) {
    house.beforeCall =
        call ->
            house.clock.schedule(
                time,
                "oven-1",
                () ->
                    house.knowledge.state(
                        new Source(Source.Kind.STATED, "oven-1"), List.of("(warm oven-1)")));
  }

  @Test
  void theStepIsOverWhenTheDeviceTellsThatItIsSo() {
    PretendHouse house = house("maestro:doneWhen \"(warm ?self)\" ; maestro:timeLimit 60");
    isHotAfter(house, Duration.ofSeconds(8));

    GoalOutcome outcome = house.achieve("(warm oven-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.calls).containsExactly("heat oven-1");
    assertThat(house.clock.now()).isBetween(Duration.ofSeconds(8), Duration.ofSeconds(9));
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "oven-1 has begun step 1; its effect is awaited, until (warm oven-1), 75 s at"
                        + " most."));
  }

  @Test
  void anEffectThatDoesNotComeIsAFailureWithItsReason() {
    PretendHouse house = house("maestro:doneWhen \"(warm ?self)\" ; maestro:timeLimit 20");

    GoalOutcome outcome = house.achieve("(warm oven-1)");

    assertThat(outcome.reached()).isFalse();
    assertThat(house.story)
        .anyMatch(
            told ->
                told.contains(
                    "oven-1 has answered, but it was not told within 35 s that (warm oven-1)"));
  }

  /** It may be as cold as before: nobody has seen it, and who answered is gone. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "maestro:effectAfter 30",
        "maestro:doneWhen \"(warm ?self)\" ; maestro:timeLimit 60"
      })
  void theEffectOfOneThatIsLostMeanwhileIsNotExpected(String timing) {
    PretendHouse house = house(timing);
    house.clock.schedule(
        Duration.ofSeconds(5), "test", () -> house.coordinator.memberLost("oven-1", "no power"));

    GoalOutcome outcome = house.achieve("(warm oven-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isFalse();
    assertThat(house.story)
        .anyMatch(told -> told.contains("oven-1 was lost before the effect was there."))
        .noneMatch(told -> told.contains("oven-1 reports: done"));
  }

  @Test
  void whatTheDeviceCannotTellIsWaitedFor() {
    PretendHouse house = house("maestro:effectAfter 30");

    GoalOutcome outcome = house.achieve("(warm oven-1)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.clock.now()).isGreaterThanOrEqualTo(Duration.ofSeconds(30));
    assertThat(house.story).anyMatch(told -> told.contains("its effect is awaited, 30 s."));
  }
}
