package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.sl.Term;

/** What a class says of each of its individuals, so that a product's data stand once. */
class EachTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/shop#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/shop> a maestro:Home ; rdfs:label "a shop"@en .
      home:room a maestro:Room ; rdfs:label "the room"@en ; maestro:outline "0 0, 5 0, 5 5, 0 5" ; maestro:height 3 .
      home:zone a maestro:Zone ; rdfs:label "the zone"@en ; maestro:outline "0 0, 5 0, 5 5, 0 5" .
      home:Bulb a owl:Class ; rdfs:subClassOf :Lamp ; rdfs:label "bulb"@en ;
        maestro:each [ maestro:luminousIntensity 80 ; :power 9 ] , [ maestro:beamAngle 120 ] .
      home:Spot a owl:Class ; rdfs:subClassOf home:Bulb ; rdfs:label "spot"@en ;
        maestro:each [ maestro:beamAngle 30 ] .
      home:plain a home:Bulb ; rdfs:label "the plain one"@en ; maestro:pose "1 1 2.5" .
      home:own a home:Bulb ; rdfs:label "the own one"@en ; maestro:pose "2 1 2.5" ; :power 11 .
      home:narrow a home:Spot ; rdfs:label "the narrow one"@en ; maestro:pose "3 1 2.5" .
      """;

  private final HomeLoader loader = new HomeLoader();

  private static Optional<Double> number(Home home, String device, String property) {
    List<Term> values =
        home.devices().get(device).individual().properties().getOrDefault(property, List.of());
    assertThat(values).hasSizeLessThan(2);
    return values.stream().map(value -> ((Term.Number) value).value()).findFirst();
  }

  @Test
  void anIndividualHasWhatItsClassSaysUnlessItSaysOtherwise() {
    Home home = loader.load(HOME, "shop.ttl");
    assertThat(number(home, "plain", "luminousIntensity")).hasValue(80.0);
    assertThat(number(home, "plain", "beamAngle")).hasValue(120.0);
    assertThat(number(home, "plain", "power")).hasValue(9.0);
    assertThat(number(home, "own", "power")).hasValue(11.0);
    assertThat(number(home, "own", "luminousIntensity")).hasValue(80.0);
  }

  @Test
  void theNarrowerClassIsBelieved() {
    Home home = loader.load(HOME, "shop.ttl");
    assertThat(number(home, "narrow", "beamAngle")).hasValue(30.0);
    assertThat(number(home, "narrow", "luminousIntensity")).hasValue(80.0);
  }

  @Test
  void theDeviceTellsItOfItself() {
    Home home = loader.load(HOME, "shop.ttl");
    String description = new DescriptionWriter(home).write(home.devices().get("narrow"));
    assertThat(description).contains("#luminousIntensity\":[80]", "#beamAngle\":[30]");
  }

  @Test
  void aFaultIsWhereTheClassSaysIt() {
    String wrong = HOME.replace("luminousIntensity 80", "luminousIntensity -80");
    assertThatThrownBy(() -> loader.load(wrong, "shop.ttl"))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("shop.ttl:10")
        .hasMessageContaining("write candela");
  }
}
