package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

class DescriptionTest {

  private static final String BLIND =
      """
      {"@context": "https://w3id.org/maestro/context.jsonld",
       "id": "https://example.org/devices#blind-1",
       "type": ["maestro:Device", "https://example.org/devices#Blind"],
       "label": "the blind", "driver": "blind", "container": "lights",
       "https://example.org/devices#slats": 24,
       "offers": {"id": "https://example.org/devices#tilt", "type": "maestro:Action",
         "input": {"name": "angle", "types": ["xsd:decimal"], "oneOf": [0, 45, 90]},
         "binds": {"name": "zone", "types": ["maestro:Zone"]},
         "precondition": "(inside ?self ?zone)",
         "effect": "(increase (illuminance ?zone) (* 2 ?angle))",
         "cost": "1.5"}}
      """;

  private final Home bob = ShippedHomes.bob();
  private final DescriptionReader reader = new DescriptionReader(bob.vocabulary());

  @Test
  void everyDeviceOfTheShippedHomesSurvivesTheWire() {
    for (Home home : List.of(bob, ShippedHomes.arena())) {
      DescriptionWriter writer = new DescriptionWriter(home);
      DescriptionReader ofHome = new DescriptionReader(home.vocabulary());
      for (Device device : home.devices().values()) {
        String text = writer.write(device);
        assertThat(ofHome.read(text, device.id())).as(text).isEqualTo(device);
        assertThat(writer.write(device)).isEqualTo(text);
      }
    }
  }

  @Test
  void aReaderWithoutTheFeatureTypesGetsThemWhole() {
    Vocabulary known = bob.vocabulary();
    Vocabulary poor = new Vocabulary(known.classes(), known.predicates(), java.util.Map.of());
    Home described = new Home(bob.iri(), bob.label(), poor, bob.individuals(), bob.devices());
    DescriptionWriter writer = new DescriptionWriter(described);
    for (Device device : bob.devices().values()) {
      assertThat(new DescriptionReader(poor).read(writer.write(device), device.id()))
          .isEqualTo(device);
    }
  }

  @Test
  void understandsADeviceThatNobodyHasHeardOf() {
    Device blind = reader.read(BLIND, "blind-1");
    assertThat(blind.individual().classes()).containsExactly("Blind", "Device");
    assertThat(blind.individual().properties())
        .containsEntry("slats", List.of(new Term.Number(24)));
    FeatureType tilt = blind.features().get(0);
    assertThat(tilt.name()).isEqualTo("tilt");
    assertThat(tilt.inputs())
        .containsExactly(
            new Parameter(
                "angle",
                List.of("decimal"),
                List.of(new Term.Number(0), new Term.Number(45), new Term.Number(90)),
                List.of(),
                false));
    assertThat(SlPrinter.print(tilt.effect()))
        .isEqualTo("(increase (illuminance ?zone) (* 2 ?angle))");
    assertThat(tilt.procedure()).isEqualTo("tilt");
  }

  @Test
  void aFeatureOfTheVocabularyNeedsOnlyWhatDiffers() {
    Device lamp =
        reader.read(
            """
            {"@context": "https://w3id.org/maestro/context.jsonld",
             "id": "https://example.org/devices#lamp-9",
             "type": "https://w3id.org/maestro/domain#Lamp",
             "offers": {"type": "https://w3id.org/maestro/domain#adjustLight", "cost": "7"}}
            """,
            "lamp-9");
    FeatureType type = bob.vocabulary().features().get("adjustLight");
    assertThat(lamp.individual().classes()).contains("Lamp", "Device");
    assertThat(lamp.features().get(0).effect()).isEqualTo(type.effect());
    assertThat(lamp.features().get(0).cost()).isNotEqualTo(type.cost());
  }

  /** A device made for a later vocabulary can join; who checks its description is told. */
  @Test
  void aWordOfALaterVocabularyIsLeftAwayAndToldOnlyToWhoChecks() {
    String later = BLIND.replaceFirst("\"type\":", "\"warranty\": \"P2Y\", \"type\":");
    assertThat(reader.read(later, "blind-1").features())
        .isEqualTo(reader.read(BLIND, "blind-1").features());
    assertThat(new DescriptionCheck(bob, reader::read).check(later, "blind.json").warnings())
        .extracting(Fault::property, Fault::cure)
        .containsExactly(
            tuple("warranty", "leave it away, or give it a prefix that your @context defines"));
  }

  @Test
  void aTimeLimitIsKeptOnTheWire() {
    String blind = BLIND.replace("\"https://example.org/devices#slats\": 24,", "");
    Device slow =
        reader.read(
            blind.replace("\"cost\": \"1.5\"", "\"cost\": \"1.5\", \"timeLimit\": 90.5"),
            "blind-1");
    assertThat(slow.features().get(0).timing().limit()).contains(Duration.ofMillis(90_500));
    assertThat(reader.read(blind, "blind-1").features().get(0).timing().limit()).isEmpty();
    Home described = bob.with(slow);
    assertThat(reader.read(new DescriptionWriter(described).write(slow), "blind-1"))
        .isEqualTo(slow);
    assertThatThrownBy(
            () ->
                reader.read(
                    blind.replace("\"cost\": \"1.5\"", "\"cost\": \"1.5\", \"timeLimit\": 0"),
                    "blind-1"))
        .hasMessageContaining("is no time that a call can have; write seconds, more than 0");
  }

  @Test
  void whatAFeatureSaysOfItsConductIsKeptOnTheWire() {
    String blind = BLIND.replace("\"https://example.org/devices#slats\": 24,", "");
    String conduct =
        """
        "cost": "1.5", "grace": 20, "chance": 0.8, "tries": 5,
        "meanwhile": "(>= (illuminance ?zone) 0)\"""";
    Device slow = reader.read(blind.replace("\"cost\": \"1.5\"", conduct), "blind-1");
    FeatureType tilt = slow.features().get(0);

    assertThat(tilt.timing().grace()).contains(Duration.ofSeconds(20));
    assertThat(tilt.reliability()).isEqualTo(new Reliability(Optional.of(0.8), Optional.of(5)));
    assertThat(SlPrinter.print(tilt.precondition()))
        .isEqualTo("(and (inside ?self ?zone) (>= (illuminance ?zone) 0))");
    assertThat(reader.read(new DescriptionWriter(bob.with(slow)).write(slow), "blind-1"))
        .isEqualTo(slow);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "\"chance\": 0 | chance is 0; write a number above 0 and at most 1",
        "\"chance\": 80 | chance is 80; write a number above 0 and at most 1",
        "\"tries\": 2.5 | tries is 2.5; write a number from 1 to 100, whole",
        "\"tries\": 0 | tries is 0; write a number from 1 to 100, whole",
        "\"grace\": -1 | grace is no time that a call can have; write seconds, more than 0",
        "\"meanwhile\": \"(open ?angel)\" | angel"
      })
  void wrongConductIsRefusedWithItsCure(String conduct, String expected) {
    String wrong = BLIND.replace("\"cost\": \"1.5\"", "\"cost\": \"1.5\", " + conduct);
    assertThatThrownBy(() -> reader.read(wrong, "blind-1")).hasMessageContaining(expected);
  }

  @Test
  void aTextIsNoThingToChoose() {
    String wrong =
        BLIND.replace(
            "\"types\": [\"maestro:Zone\"]",
            "\"types\": [\"maestro:Zone\"], \"oneOf\": [\"zone-a\"]");
    assertThatThrownBy(() -> reader.read(wrong, "blind-1"))
        .hasMessageContaining(
            "gives \"zone-a\" for zone, which is to be a Zone; write the thing, in JSON-LD as");
  }

  @Test
  void aMemberSpeaksOnlyOfItself() {
    assertThatThrownBy(() -> reader.read(BLIND, "blind-2"))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("does not speak of blind-2");
    String meddling =
        BLIND.replace(
            "\"label\": \"the blind\"",
            "\"maestro:note\": {\"id\": \"https://w3id.org/maestro/home/bob#rose\", \"label\": \"x\"}");
    assertThatThrownBy(() -> reader.read(meddling, "blind-1"))
        .hasMessageContaining("blind-1: rose is not for blind-1 to describe");
    String redefining =
        BLIND.replace("https://example.org/devices#tilt", "https://w3id.org/maestro/domain#pick");
    assertThatThrownBy(() -> reader.read(redefining, "blind-1"))
        .hasMessageContaining("pick is not for blind-1 to describe");
  }

  @Test
  void faultsInADescriptionNameWhatIsWrong() {
    assertThatThrownBy(
            () -> reader.read(BLIND.replace("(inside ?self ?zone)", "(inside ?self"), "blind-1"))
        .hasMessageContaining("tilt")
        .hasMessageContaining("column 14");
    assertThatThrownBy(
            () ->
                reader.read(
                    BLIND.replace("w3id.org/maestro/context", "example.org/other"), "blind-1"))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("https://example.org/other.jsonld");
    assertThatThrownBy(() -> reader.read("{\"@context\": ", "blind-1"))
        .isInstanceOf(HomeFaultException.class);
    assertThatThrownBy(() -> reader.read(BLIND.replace("\"maestro:Device\",", ""), "blind-1"))
        .hasMessageContaining("is no maestro:Device");
  }
}
