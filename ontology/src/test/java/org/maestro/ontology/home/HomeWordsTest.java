package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;

/**
 * The words that a home file adds to the vocabulary go where the file itself does not: with them a
 * process that has joined reads descriptions as the platform's own does.
 */
class HomeWordsTest {
  private static final String POST =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/post#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/post> a maestro:Home ; rdfs:label "a post office"@en .
      :Letter a owl:Class ; rdfs:subClassOf maestro:Thing ; rdfs:label "letter"@en .
      :stamped a maestro:Predicate ; rdfs:label "stamped"@en ;
        maestro:arguments ( "?l - Letter" ) .
      :stamp a maestro:Task ; maestro:order 500 ;
        maestro:sentence "{self} stamps {letter}" ;
        maestro:input [ maestro:name "letter" ; maestro:type :Letter ] ;
        maestro:precondition "(and (not (stamped ?letter)) (not (stamped first-letter)))" ;
        maestro:effect "(stamped ?letter)" ;
        maestro:occupies ( "plate" ) ; maestro:cost "1" ; maestro:seconds "60" .
      :Press a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "press"@en ;
        maestro:offers :stamp .
      home:first-letter a :Letter ; rdfs:label "the first letter"@en .
      home:press a :Press .
      """;

  private final HomeLoader loader = new HomeLoader();
  private final Home post = loader.load(POST, "post.ttl");

  @Test
  void aProcessThatHasTheWordsOnlyReadsADescriptionAsTheWholeHomeDoes() {
    Device press = post.devices().get("press");
    String said = new DescriptionWriter(post).write(press);

    assertThat(new DescriptionReader(loader.vocabularyWith(post.words())).read(said, "press"))
        .isEqualTo(press);
    assertThatThrownBy(() -> new DescriptionReader(loader.vocabulary()).read(said, "press"))
        .isInstanceOf(HomeFaultException.class);
  }

  @Test
  void aDeviceThatNamesOnlyItsClassOffersWhatTheHomeGivesThatClass() {
    String said =
        """
        {"@context": "https://w3id.org/maestro/context.jsonld",
         "id": "https://w3id.org/maestro/home/post#press",
         "type": "https://w3id.org/maestro/domain#Press"}
        """;

    assertThat(DescriptionReader.of(post).read(said, "press").features())
        .isEqualTo(post.devices().get("press").features());
  }

  @Test
  void aDeviceOfAShippedClassOffersWhatTheHomeAddsToThatClass() {
    Home blinking = loader.load(POST + ":Lamp maestro:offers :stamp .\n", "post.ttl");
    String said =
        """
        {"@context": "https://w3id.org/maestro/context.jsonld",
         "id": "https://w3id.org/maestro/home/post#lamp-1",
         "type": "https://w3id.org/maestro/domain#Lamp",
         "luminousIntensity": 900, "beamAngle": 100, "pose": "1 1 2.8",
         "https://w3id.org/maestro/domain#power": 8}
        """;

    assertThat(DescriptionReader.of(blinking).read(said, "lamp-1").features())
        .extracting(FeatureType::name)
        .contains("stamp", "adjustLight");
  }

  @Test
  void aHomeThatAddsNothingHasNoWords() {
    assertThat(ShippedHomes.bob().words()).isEmpty();
    assertThat(loader.vocabularyWith("")).isEqualTo(loader.vocabulary());
  }

  @Test
  void theWordsAreThoseOfTheVocabularyAndNotTheThings() {
    assertThat(post.words()).contains("stamp", "Press").doesNotContain("home/post#press");
    assertThat(loader.vocabularyWith(post.words())).isEqualTo(post.vocabulary());
  }
}
