package org.maestro.language;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Which language is spoken: that of the person, else of the home, else English. */
class SpokenLanguageTest {
  private static Home home(String ofTheHome, String ofBob) {
    return new HomeLoader()
        .load(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/tiny#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
            <https://w3id.org/maestro/home/tiny> a maestro:Home ; %s rdfs:label "tiny"@en .
            home:room a maestro:Room , maestro:Zone ; rdfs:label "die Stube"@de ;
              maestro:outline "0 0, 4 0, 4 4, 0 4" ; maestro:height 2.5 ; maestro:referencePoint "2 2 0" .
            home:Bob a :Person ; %s rdfs:label "Bob"@en ; :colour "blue" ; :size "0.5 0.5 1.8" .
            """
                .formatted(said(ofTheHome), said(ofBob)),
            "tiny.ttl");
  }

  private static String said(String tag) {
    return tag.isEmpty() ? "" : "maestro:language \"%s\" ;".formatted(tag);
  }

  private static String spoken(String ofTheHome, String ofBob) {
    return Language.spoken(home(ofTheHome, ofBob), Optional.of("Bob"));
  }

  @Test
  void aPersonSpeaksHerLanguageElseThatOfTheHome() {
    assertThat(spoken("", "")).isEqualTo("en");
    assertThat(spoken("de", "")).isEqualTo("de");
    assertThat(spoken("", "de")).isEqualTo("de");
    assertThat(spoken("de", "en")).isEqualTo("en");
    assertThat(Language.spoken(home("de", "en"), Optional.empty())).isEqualTo("de");
  }

  @Test
  void whatIsNotShippedIsNotSpoken() {
    assertThat(spoken("xx", "")).isEqualTo("en");
    assertThatThrownBy(() -> Language.of(home("", ""), "xx"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage(
            "There is no grammar for the language xx; name one that is shipped, such as de, or a"
                + " file such as nl.grammar.");
    assertThatThrownBy(() -> Language.of(home("", ""), "../de"))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void aNameOfNoOtherLanguageIsOneInEach() {
    assertThat(Language.of(home("", ""), "de").lexicon().knows("bob")).isTrue();
    assertThat(Language.of(home("", ""), "en").lexicon().knows("stube")).isTrue();
  }
}
