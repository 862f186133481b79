package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * Devices that describe themselves in words of other vocabularies (Three-layered architecture, 1;
 * M7).
 */
class ForeignWordsTest {

  private static final String HEAD =
      """
      {"@context": ["https://w3id.org/maestro/context.jsonld", {
         "sosa": "http://www.w3.org/ns/sosa/", "ssn": "http://www.w3.org/ns/ssn/",
         "saref": "https://saref.etsi.org/core/", "s4bldg": "https://saref.etsi.org/saref4bldg/",
         "css": "http://www.w3id.org/hsu-aut/css#", "bot": "https://w3id.org/bot#",
         "domain": "https://w3id.org/maestro/domain#"}],
       "id": "https://example.org/devices#stranger-1",
      """;

  private final Home bob = ShippedHomes.bob();
  private final DescriptionReader reader = new DescriptionReader(bob.vocabulary());

  private Device read(String rest) {
    return reader.read(HEAD + rest + "}", "stranger-1");
  }

  private static List<String> features(Device device) {
    return device.features().stream().map(FeatureType::name).toList();
  }

  @Test
  void aSensorIsWhatItObserves() {
    Device sensor =
        read(
            """
            "type": "sosa:Sensor", "sosa:observes": {"id": "domain:illuminance"}, "pose": "1 1 0"
            """);
    assertThat(sensor.individual().classes()).contains("LightSensor", "Device");
    assertThat(features(sensor)).containsExactly("measureIllumination");
  }

  @Test
  void anActuatorIsWhatItActsOn() {
    Device lamp =
        read(
            """
            "type": "sosa:Actuator", "ssn:forProperty": {"id": "domain:level"}
            """);
    assertThat(lamp.individual().classes()).contains("Lamp");
    assertThat(lamp.reports()).containsEntry("level", "(= (level ?self) ?level)");
    assertThat(lamp.container()).contains("lights");
  }

  @Test
  void aLightSwitchOfSarefKnowsOnAndOffOnly() {
    Device lamp =
        read(
            """
            "type": "saref:LightSwitch", "pose": "1 1 2.5", "luminousIntensity": 400
            """);
    assertThat(lamp.individual().classes()).contains("Lamp", "LightSwitch");
    assertThat(features(lamp)).containsExactly("adjustLight");
    assertThat(lamp.features().get(0).inputs().get(0).oneOf())
        .containsExactly(new Term.Number(0), new Term.Number(1));
  }

  @Test
  void aSensorOfSarefSpeaksForTheSpaceThatContainsIt() {
    Device sensor =
        read(
            """
            "type": "saref:Sensor", "saref:measuresProperty": {"id": "saref:Light"},
            "s4bldg:isContainedIn": {"id": "https://w3id.org/maestro/home/bob#zone-b"}
            """);
    assertThat(features(sensor)).containsExactly("measureIllumination");
    assertThat(sensor.individual().properties())
        .containsEntry("speaksFor", List.of(new Term.Name("zone-b")));
  }

  @Test
  void aResourceProvidesSkills() {
    Device robot =
        read(
            """
            "type": "css:Resource", "css:providesSkill": [{"id": "domain:move"}, {"id": "domain:pick"}]
            """);
    assertThat(robot.individual().classes()).contains("Device").doesNotContain("MobileRobot");
    assertThat(features(robot)).containsExactlyInAnyOrder("move", "pick");
  }

  @Test
  void aNameAloneIsNoKinship() {
    Device odd =
        read(
            """
            "type": ["sosa:Sensor", "bot:Zone"], "sosa:observes": {"id": "domain:illuminance"}
            """);
    assertThat(odd.individual().classes()).doesNotContain("Zone");
  }

  @Test
  void whatOffersSomethingHasNoMoreThanThat() {
    Device lamp =
        read(
            """
            "type": "s4bldg:Lamp", "offers": {"type": "domain:adjustLight", "cost": 7}
            """);
    assertThat(features(lamp)).containsExactly("adjustLight");
    assertThat(lamp.reports()).isEmpty();
  }

  @Test
  void aStrangerOfUnknownKindIsRefused() {
    assertThatThrownBy(() -> read("\"type\": \"https://example.org/what#Ever\""))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("is no maestro:Device");
  }

  @Test
  void homesMayBeWrittenInForeignWordsToo() {
    Home home =
        new HomeLoader()
            .load(
                ShippedHomes.text("bob.ttl")
                    + """
                    <#glow-1> a <https://saref.etsi.org/core/LightSwitch> ;
                      maestro:pose "4.5 1.5 2.8" ; maestro:luminousIntensity 400 ; :power 5 .
                    """,
                "bob.ttl");
    assertThat(home.devices().get("glow-1").individual().classes()).contains("Lamp");
    assertThat(features(home.devices().get("glow-1"))).containsExactly("adjustLight");
  }
}
