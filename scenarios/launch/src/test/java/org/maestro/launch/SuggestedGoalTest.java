package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.home.HomeLoader;

class SuggestedGoalTest {

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {"bob|(nextTo Cup Bob)", "arena|(nextTo GreenObject RedObject1)"})
  void isAboutThingsOfTheHome(String home, String goal) {
    assertThat(SuggestedGoal.of(Shipped.home(home))).contains(goal);
  }

  @Test
  void isNoneWhereNothingCanBeBroughtAbout() {
    String empty =
        """
        @prefix maestro: <https://w3id.org/maestro#> .
        @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
        <https://w3id.org/maestro/home/empty> a maestro:Home ; rdfs:label "an empty home"@en .
        """;
    assertThat(SuggestedGoal.of(new HomeLoader().load(empty, "empty.ttl"))).isEmpty();
  }
}
