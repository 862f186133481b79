package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.ontology.vocabulary.Share;
import org.maestro.sl.SlParser;

/** A home says of which number a word of its is a share. */
class ShareTest {
  private static final String HOME =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/hall#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/hall> a maestro:Home ; rdfs:label "a hall"@en .
      home:warmth a maestro:%s ; rdfs:label "warmth"@en ;
        maestro:arguments ( "?h - Device" "?z - Location" ) ;
        maestro:shareOf [ %s ] .
      """;

  private static Home home(String kind, String share) {
    return new HomeLoader().load(HOME.formatted(kind, share), "hall.ttl");
  }

  @Test
  void ofWhichNumberAndByWhichSetting() {
    Share share =
        home("Fluent", "maestro:number \"(illuminance ?z)\" ; maestro:times \"(level ?h)\"")
            .vocabulary()
            .predicate("warmth")
            .orElseThrow()
            .shareOf()
            .orElseThrow();

    assertThat(share.number()).isEqualTo(SlParser.expression("(illuminance ?z)"));
    assertThat(share.setting()).isEqualTo(SlParser.expression("(level ?h)"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "Fluent | maestro:number \"(illuminance ?z)\" | does not say of what, and by which setting",
        "Fluent | maestro:number \"(illuminance ?z)\" ; maestro:times \"(illuminance ?z)\" | leaves an argument",
        "Predicate | maestro:number \"(illuminance ?z)\" ; maestro:times \"(level ?h)\" | of what is no number",
        "Fluent | maestro:number \"(lumen ?z)\" ; maestro:times \"(level ?h)\" | unknown fluent lumen",
      })
  void whatIsWrongIsSaid(String kind, String share, String fault) {
    assertThatThrownBy(() -> home(kind, share))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("hall.ttl:9")
        .hasMessageContaining(fault);
  }
}
