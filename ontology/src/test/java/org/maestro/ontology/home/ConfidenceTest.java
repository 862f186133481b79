package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.Doubt;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** How sure a source is, stands in the home or in what a device says of itself. */
class ConfidenceTest {

  private static final String BOB = ShippedHomes.text("bob.ttl");
  private static final String CAMERA = "home:cam-b a :Camera ;";
  private static final String SENSOR = "home:lux-b a :LightSensor ;";

  @Test
  void ofADeviceItIsANumber() {
    Home home = load(CAMERA, CAMERA + " maestro:confidence 0.6 ;");

    assertThat(home.individuals().get("cam-b").properties().get("confidence"))
        .isEqualTo(List.of(new Term.Number(0.6)));
    assertDescribesItself(home, "cam-b");
  }

  @Test
  void ofAFeatureItIsANumberOrDependsOnAFormula() {
    assertThat(measuring(load("", "")))
        .singleElement()
        .satisfies(
            doubt -> {
              assertThat(doubt.confidence()).isEqualTo(0.4);
              assertThat(SlPrinter.print(doubt.when())).contains("speaksFor");
            });
    Home home =
        load(
            SENSOR,
            SENSOR
                + " maestro:offers [ a :measureIllumination ; maestro:confidence 0.8 ,"
                + " [ maestro:upTo 0.2 ; maestro:when \"(in ?self ?zone)\" ] ] ;");
    assertThat(measuring(home)).extracting(Doubt::confidence).containsExactlyInAnyOrder(0.8, 0.2);
    assertDescribesItself(home, "lux-b");
  }

  @Test
  void whatIsNoConfidenceIsAFaultThatSaysWhatWouldBeRight() {
    assertFault(
        CAMERA,
        CAMERA + " maestro:confidence 60 ;",
        "cam-b maestro:confidence \"60\" is not a number from 0 to 1");
    assertFault(
        SENSOR,
        SENSOR + " maestro:offers [ a :measureIllumination ; maestro:confidence [ ] ] ;",
        "is neither a number nor a node with maestro:upTo and maestro:when");
    assertFault(
        SENSOR,
        SENSOR
            + " maestro:offers [ a :measureIllumination ; maestro:confidence"
            + " [ maestro:upTo 0.2 ; maestro:when \"(insid ?self ?zone)\" ] ] ;",
        "uses the unknown predicate insid");
  }

  private static List<Doubt> measuring(Home home) {
    return home.devices().get("lux-b").features().stream()
        .filter(feature -> feature.name().equals("measureIllumination"))
        .findFirst()
        .map(FeatureType::doubts)
        .orElseThrow();
  }

  private static void assertDescribesItself(Home home, String device) {
    Device stated = home.devices().get(device);
    assertThat(
            new DescriptionReader(home.vocabulary())
                .read(new DescriptionWriter(home).write(stated), device))
        .isEqualTo(stated);
  }

  private static void assertFault(String right, String wrong, String expected) {
    assertThatThrownBy(() -> load(right, wrong))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining(expected);
  }

  private static Home load(String right, String wrong) {
    return new HomeLoader().load(BOB.replace(right, wrong), "bob.ttl");
  }
}
