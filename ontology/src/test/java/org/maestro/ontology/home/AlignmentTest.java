package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class AlignmentTest {

  /**
   * Alignments only add superclasses and superproperties of other vocabularies; homes stay as they
   * are.
   */
  @ParameterizedTest
  @ValueSource(strings = {"sosa", "css", "bot", "td"})
  void loadsBesideTheVocabulary(String name) throws IOException {
    String alignment =
        Files.readString(
            Path.of("src/main/resources/org/maestro/ontology/alignment/" + name + ".ttl"));
    Home aligned =
        HomeLoader.withVocabulary(List.of(HomeLoader.shippedVocabulary(), alignment))
            .load(ShippedHomes.text("bob.ttl"), "bob.ttl");
    assertThat(aligned.devices().keySet()).isEqualTo(ShippedHomes.bob().devices().keySet());
    assertThat(aligned.vocabulary().features())
        .isEqualTo(ShippedHomes.bob().vocabulary().features());
  }
}
