package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;
import org.maestro.knowledge.api.Belief;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** Persons who are followed through all rooms by one agent (A2, A74, A84). */
@MaestroTest(home = "people", scene = "people")
class PersonsTest {
  private static final String HEADING = "(headingTo Dave livingroom)";

  private static Optional<Belief> known(Stage stage, String atom) {
    Formula.Atom asked = (Formula.Atom) SlParser.formula(atom);
    return stage.knowledge().snapshot().belief(asked).filter(belief -> belief.fact().equals(atom));
  }

  private static boolean isIn(Stage stage, String person, String zone) {
    return stage.world().zone(person).filter(zone::equals).isPresent();
  }

  /** How long before his arrival it is foretold, each time that he goes there; empty: it is not. */
  private static List<Optional<Duration>> arrivals(Stage stage, int number) {
    List<Optional<Duration>> foretold = new ArrayList<>();
    for (int i = 0; i < number; i++) {
      stage.await("Dave walks along the hallway", () -> isIn(stage, "Dave", "hallway"));
      Optional<Duration> since = Optional.empty();
      while (isIn(stage, "Dave", "hallway")) {
        if (since.isEmpty() && known(stage, HEADING).isPresent()) {
          since = Optional.of(stage.clock().now());
        }
        stage.run(Duration.ofMillis(200));
      }
      assertThat(isIn(stage, "Dave", "livingroom")).isTrue();
      foretold.add(since.map(stage.clock().now()::minus));
      stage.await("Dave is outside", () -> isIn(stage, "Dave", "garden"));
    }
    return foretold;
  }

  @Test
  void theGuessThatHeGoesToTheLivingRoomPrecedesHisArrival(Stage stage) {
    List<Optional<Duration>> foretold = arrivals(stage, 8);

    assertThat(foretold.get(0)).as("nothing is known of him yet").isEmpty();
    assertThat(foretold.subList(4, 8))
        .as("he has done so often; now and then all sensors miss him on his way")
        .anySatisfy(
            before ->
                assertThat(before)
                    .hasValueSatisfying(
                        time -> assertThat(time).isGreaterThan(Duration.ofSeconds(2))));
    assertThat(known(stage, HEADING)).as("he is outside again").isEmpty();
  }

  @Test
  void oneTrackerIsFedByAllRoomsAndToldOfToAll(Stage stage) {
    stage.await(
        "all three are known",
        () ->
            known(stage, "(in Dave livingroom)").isPresent()
                && known(stage, "(in Rose kitchen)").isPresent()
                && known(stage, "(probablyIn Tom kidsroom)").isPresent());

    assertThat(List.of("(in Dave livingroom)", "(in Rose kitchen)"))
        .allSatisfy(
            fact ->
                assertThat(known(stage, fact).orElseThrow().source().agent()).isEqualTo("persons"));
    assertThat(stage.platform().directory().agents())
        .filteredOn(entry -> entry.agent().equals("persons"))
        .hasSize(1);
  }

  @Test
  void whoAsksIsToldWhereSomebodyIsAndWhereSheProbablyIs(Stage stage) {
    stage.await("Rose is known", () -> known(stage, "(in Rose kitchen)").isPresent());
    stage.await("Tom is known", () -> known(stage, "(in Tom kidsroom)").isPresent());
    Speaker rose = stage.speaker("Rose").in("kitchen");
    rose.says("where is Tom?").replies("The kids' room.");
    rose.says("where are the kids?").replies("Tom: the kids' room.");

    stage.await("Dave is likely", () -> known(stage, "(probablyIn Dave garden)").isPresent());
    assertThat(known(stage, "(in Dave garden)")).isEmpty();
    rose.says("where is Dave?")
        .means("(query-ref (in Dave ?where))")
        .replies("Probably the garden.");
  }

  @Test
  void whoSpeaksInARoomIsThere(Stage stage) {
    stage.speaker("Dave").in("bathroom").says("hello");

    assertThat(known(stage, "(heardIn Dave bathroom)").orElseThrow().source().agent())
        .isEqualTo("bathroom");
  }

  @Test
  void anotherTrackerBeginsInThePlaceOfOneThatEnded(Stage stage) {
    stage.await("Rose is known", () -> known(stage, "(in Rose kitchen)").isPresent());
    Instant ended = stage.platform().instant();
    stage.platform().endAgent("persons");

    stage.await(
        "another is there",
        () ->
            stage
                .platform()
                .directory()
                .find("persons")
                .filter(one -> !one.since().isBefore(ended))
                .isPresent());
    stage.run(Duration.ofSeconds(60));
    assertThat(known(stage, "(in Rose kitchen)")).isPresent();
  }
}
