package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Effect;

/**
 * The features of sensors take in nothing, those of actuators give out nothing (Three-layered
 * architecture, 3.2.2; M47). What a sensor is called with says of what it shall tell, which is no
 * input of its own: always the name of something, never a quantity.
 */
class SensorsAndActuatorsTest {

  @ParameterizedTest
  @ValueSource(
      strings = {
        "arena",
        "arena-windows",
        "bob",
        "bob-two-robots",
        "broken-cup",
        "evening",
        "flat",
        "household",
        "livingroom",
        "study"
      })
  void keepToTheirKind(String home) throws IOException {
    Map<String, FeatureType> features = features(home);
    assertThat(features).isNotEmpty();
    features.forEach(
        (name, feature) -> {
          if (senses(feature.effect())) {
            assertThat(feature.outputs()).as(name + " tells something").isNotEmpty();
            assertThat(feature.inputs())
                .as(name + " takes in nothing but of what to tell")
                .allMatch(SensorsAndActuatorsTest::isSelector);
          } else {
            assertThat(feature.outputs()).as(name + " acts, and tells nothing").isEmpty();
          }
        });
  }

  @Test
  void bothKindsAreShipped() throws IOException {
    Map<String, FeatureType> features = features("flat");
    assertThat(features.values()).anyMatch(feature -> senses(feature.effect()));
    assertThat(features.values()).anyMatch(feature -> !senses(feature.effect()));
  }

  private static boolean isSelector(Parameter input) {
    return input.types().stream()
        .noneMatch(
            type ->
                Parameter.OWN_DATATYPES.contains(type) || Character.isLowerCase(type.charAt(0)));
  }

  private static boolean senses(Effect effect) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(SensorsAndActuatorsTest::senses);
    } else if (effect instanceof Effect.When when) {
      return senses(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      return senses(forall.effect());
    }
    return effect instanceof Effect.SenseAtom || effect instanceof Effect.SenseNumber;
  }

  private static Map<String, FeatureType> features(String name) throws IOException {
    String path = "/homes/" + name + ".ttl";
    try (var text = SensorsAndActuatorsTest.class.getResourceAsStream(path)) {
      Home home =
          new HomeLoader().load(new String(text.readAllBytes(), StandardCharsets.UTF_8), path);
      Map<String, FeatureType> features = new TreeMap<>();
      home.devices().values().stream()
          .map(device -> List.copyOf(device.features()))
          .forEach(all -> all.forEach(feature -> features.put(feature.name(), feature)));
      return features;
    }
  }
}
