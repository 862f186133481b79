package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Truth;

/** Named points and areas inside a zone, such as a desk. */
class LocationTest {
  private final Home home =
      new HomeLoader()
          .load(
              ShippedHomes.text("bob.ttl")
                  + """

                  home:desk a maestro:Location ; rdfs:label "the desk" ;
                    maestro:outline "4.5 0.5, 5.5 0.5, 5.5 1, 4.5 1" ; maestro:referencePoint "5 0.75 0.75" .
                  home:spot a maestro:Location ; rdfs:label "a point" ; maestro:position "4.1 1.5 0.8" .
                  home:desk-sensor a :LightSensor ; maestro:pose "5 0.6 0.75" .
                  """,
              "test.ttl");
  private final HomeFacts facts = new HomeFacts(home);

  @Test
  void lightIsReckonedAtThePointItself() {
    // lamp-b1 at (4.1, 1.5, 2.8), straight above the point: I / h^2
    assertThat(number("(gain lamp-b1 spot)")).isCloseTo(505 / 4.0, within(1e-9));
    double height = 2.8 - 0.75;
    double slant = Math.hypot(Math.hypot(0.9, 0.75), height);
    assertThat(number("(gain lamp-b1 desk)"))
        .isCloseTo(505 * height / Math.pow(slant, 3), within(1e-9));
    assertThat(number("(gain lamp-a1 desk)")).isZero();
  }

  @Test
  void itLiesInsideItsZone() {
    assertThat(truth("(inside desk zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(inside spot zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(inside desk zone-a)")).isEqualTo(Truth.FALSE);
    assertThat(truth("(inside desk-sensor desk)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(inside zone-b spot)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void aSensorSpeaksForTheClosestLocationAroundIt() {
    assertThat(truth("(senses desk-sensor desk)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(senses desk-sensor zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(truth("(senses lux-b zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(reckonedFrom desk zone-b)")).isEqualTo(Truth.FALSE);
    assertThat(truth("(reckonedFrom spot zone-b)")).isEqualTo(Truth.TRUE);
    assertThat(truth("(reckonedFrom zone-b spot)")).isEqualTo(Truth.FALSE);
  }

  @Test
  void aZoneIsALocationAndALocationIsNoPlace() {
    assertThat(home.individuals().get("zone-a").classes()).contains("Location", "Place");
    assertThat(home.individuals().get("desk").classes()).containsExactly("Location");
  }

  private double number(String fluent) {
    Formula.Comparison comparison = (Formula.Comparison) SlParser.formula("(= " + fluent + " 0)");
    return facts.number((Expression.Fluent) comparison.left()).orElseThrow();
  }

  private Truth truth(String atom) {
    return facts.truth((Formula.Atom) SlParser.formula(atom));
  }
}
