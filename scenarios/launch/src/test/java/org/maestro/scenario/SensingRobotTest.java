package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.knowledge.api.Belief;
import org.maestro.sim.world.World;
import org.maestro.sl.Expression;
import org.maestro.sl.Term;

/**
 * A robot with the sensors that a room lacks: it measures and looks there, and heeds who does not
 * want it there (ADE, 5; A89).
 */
@MaestroTest(home = "/unsensed.ttl", scene = "/unsensed-night.ttl")
class SensingRobotTest {
  private static final Expression.Fluent LIGHT =
      new Expression.Fluent("illuminance", List.of(new Term.Name("bedroom")));
  private static final String WISH = "(nextTo Book Bob)";
  private static final Position ON_THE_SOFA = new Position(2.4, 0.5, 0);

  /** So long it counts that somebody was not seen somewhere. */
  private static final Duration UNTIL_IT_MAY_BE_OTHERWISE = Duration.ofSeconds(31);

  @Test
  void theRobotMeasuresAndLooksInARoomWithoutAnySensor(Stage stage) {
    stage.world().moveByHand("Ada", ON_THE_SOFA);

    assertThat(stage.goal(WISH))
        .isReached()
        .isConfirmed()
        .tells("rose measures the light in bedroom")
        .tells("bed-lamp is set to")
        .tells("rose looks around for Book in bedroom");

    assertThat(stage.world()).hasNextTo("Book", "Bob");
    List<Belief> measured = stage.platform().knowledge().history("(illuminance bedroom)");
    assertThat(measured)
        .as("who has measured in the bedroom")
        .filteredOn(belief -> belief.source().agent().equals("rose"))
        .isNotEmpty();
    assertThat(stage.platform().knowledge().history("(in Book bedroom)"))
        .extracting(belief -> belief.source().agent())
        .contains("rose");
  }

  /** What it measures is the light where it stands, and known to be from it. */
  @Test
  void whatItMeasuresIsWhatIsThere(Stage stage) {
    stage.world().moveByHand("Ada", ON_THE_SOFA);

    assertThat(stage.goal("(and (in rose bedroom) (>= (illuminance bedroom) 5))")).isReached();

    Belief measured = stage.platform().knowledge().snapshot().belief(LIGHT).orElseThrow();
    assertThat(measured.source().agent()).isEqualTo("rose");
    World world = stage.world();
    assertThat(measured.fact()).contains("illuminance bedroom");
    assertThat(number(measured.fact()))
        .isCloseTo(world.lux(world.position("rose").orElseThrow()), within(3.0));
  }

  private static double number(String fact) {
    return Double.parseDouble(fact.replaceAll(".* ([0-9.]+)\\)$", "$1"));
  }

  @Test
  void whoWantsNoRobotIsNotVisitedAndTheRefusalSaysWhy(Stage stage) {
    assertThat(stage.goal(WISH))
        .isNotReached()
        .tells("eye looks for Ada in living")
        .isExplainedBy(
            "It is needed that Ada is not averse to robots in bedroom, so that rose drives to"
                + " bedroom");
    assertThat(stage.world().path("rose"))
        .as("it has not been in the bedroom")
        .allMatch(corner -> corner.point().x() < 3);

    stage.world().moveByHand("Ada", ON_THE_SOFA);
    stage.run(UNTIL_IT_MAY_BE_OTHERWISE);

    assertThat(stage.goal(WISH)).isReached().tells("eye looks for Ada in living");
    assertThat(stage.world().zone("Ada")).isEqualTo(Optional.of("living"));
  }

  @Test
  void itIsABodyThatCamerasSee(Stage stage) {
    assertThat(stage.goal("(canSee eye rose)")).isReached();
  }
}
