package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What no device of a home can do with a thing, by what the home states. */
class ImpossibleUsesTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://example.org/heavy#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://example.org/heavy> a maestro:Home .
      home:hall a maestro:Zone ; maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:referencePoint "2 2 0" .
      home:Mug a :Item ; :size "0.08 0.08 0.1" ; :mass %s .
      home:rose a :MobileRobot ; :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 0.5 .
      home:tim a :MobileRobot ; :size "0.58 0.38 0.4" ; :speed 0.8 ; :payload 1.5 .
      """;

  @Test
  void areNamedWithTheNumbersOfAllWhoCannot() {
    assertThat(ImpossibleUses.of(home("2")))
        .containsExactly(
            "Nobody can do pick with Mug: the mass of Mug (2) has to be <= the payload of rose"
                + " (0.5); the mass of Mug (2) has to be <= the payload of tim (1.5).");
  }

  @Test
  void areNoneWhereOneCan() {
    assertThat(ImpossibleUses.of(home("1.2"))).isEmpty();
  }

  private static Home home(String mass) {
    return new HomeLoader().load(HOME.formatted(mass), "heavy.ttl");
  }
}
