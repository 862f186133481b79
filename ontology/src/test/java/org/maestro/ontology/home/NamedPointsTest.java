package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/** Points in Bob's two rooms that a goal names by their coordinates. */
class NamedPointsTest {
  private static final Home BOB = ShippedHomes.bob();

  @Test
  void areLocationsOfOneZoneInWhichTheLightIsReckoned() {
    NamedPoints points = named("(>= (illuminance (at 4.1 1.5 0.8)) 120)");
    HomeFacts facts = new HomeFacts(points.in(BOB));

    assertThat(points.objection(BOB)).isEmpty();
    assertThat(truth(facts, "(Location at_4.1_1.5_0.8)")).isEqualTo(Truth.TRUE);
    assertThat(truth(facts, "(reckonedFrom at_4.1_1.5_0.8 zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth(facts, "(reckonedFrom at_4.1_1.5_0.8 zone-a)")).isEqualTo(Truth.FALSE);
    Expression gain = SlParser.expression("(gain lamp-b1 at_4.1_1.5_0.8)");
    assertThat(facts.number((Expression.Fluent) gain).orElseThrow())
        .as("505 cd, two metres above")
        .isCloseTo(505 / 4.0, within(1e-9));
    assertThat(points.notIn(points.in(BOB))).isEqualTo(BOB);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(at 9 0.8) | names (at 9 0.8 0), which lies outside of all zones | zone-b, the nearest, has its middle at (at 4.5 1.5)",
        "(at 3 0.8) | names (at 3 0.8 0), which lies in a wall | name a point beside it",
        "(at 3 2.2) | which lies on the border of zone-a and zone-b | name a point within one",
        "(at 1 1 2.9) | which lies below the floor or above the ceiling | the height in metres",
        "(at 1 1 -0.1) | which lies below the floor or above the ceiling | the height in metres"
      })
  void whatLiesNowhereIsRefusedWithACure(String point, String problem, String cure) {
    assertThat(named("(nextTo Cup %s)".formatted(point)).objection(BOB))
        .hasValueSatisfying(
            found -> {
              assertThat(found.problem()).contains(problem);
              assertThat(found.cure()).contains(cure);
            });
  }

  @Test
  void aHomesFileMayNameThem() {
    String asks = "maestro:pursues \"(>= (illuminance (at %s 1.5 0.8)) 120)\" ; :speed 0.8";
    String bob = ShippedHomes.text("bob.ttl");

    Home home = new HomeLoader().load(bob.replace(":speed 0.8", asks.formatted("4.1")), "bob.ttl");

    assertThat(home.individuals()).containsKey("at_4.1_1.5_0.8");
    assertThatThrownBy(
            () -> new HomeLoader().load(bob.replace(":speed 0.8", asks.formatted("41")), "bob.ttl"))
        .hasMessageContaining("rose names (at 41 1.5 0.8), which lies outside of all zones");
  }

  private static NamedPoints named(String goal) {
    return NamedPoints.of(SlParser.formula(goal));
  }

  private static Truth truth(HomeFacts facts, String atom) {
    return facts.truth((Formula.Atom) SlParser.formula(atom));
  }
}
