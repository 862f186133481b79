package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Term;

/**
 * The words of households are there for homes that use them, give way to a home's own, and say of
 * appliances what can be set.
 */
class HouseholdWordsTest {
  private static final String FLAT =
      """
      @prefix : <https://w3id.org/maestro/domain#> .
      @prefix home: <https://w3id.org/maestro/home/flat#> .
      @prefix maestro: <https://w3id.org/maestro#> .
      @prefix owl: <http://www.w3.org/2002/07/owl#> .
      @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
      <https://w3id.org/maestro/home/flat> a maestro:Home ; rdfs:label "a flat"@en .
      """;
  private static final String STEREO = "home:stereo a :Stereo ; rdfs:label \"the stereo\"@en .\n";

  private final HomeLoader loader = new HomeLoader();

  private Home flat(String rest) {
    return loader.load(FLAT + rest, "flat.ttl");
  }

  @Test
  void whoUsesOneOfThemHasThemAll() {
    Vocabulary words = flat(STEREO).vocabulary();

    assertThat(words.classes()).containsKeys("Stereo", "Oven", "Film");
    assertThat(words.predicates()).containsKeys("volume", "playing", "on");
    assertThat(words.features()).containsKeys("setVolume", "lockDoor");
  }

  @Test
  void whoUsesNoneDoesNotHaveThemUnlessHeSaysSo() {
    assertThat(flat("").vocabulary()).isEqualTo(loader.vocabulary());
    assertThat(flat("").vocabulary().classes()).doesNotContainKey("Stereo");
    assertThat(
            flat("<https://w3id.org/maestro/home/flat> maestro:speaks <https://w3id.org/maestro/household> .")
                .vocabulary()
                .classes())
        .containsKey("Stereo");
  }

  @Test
  void whatAHomeCallsOtherwiseGoesBeforeThemWithAllThatIsBuiltOnIt() {
    Home home =
        flat(
            """
                home:hob a :Hob ; rdfs:label "the hob"@en .
                home:Oven a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "kiln"@en .
                home:Glass a :Item ; rdfs:label "the glass"@en .
                home:volume a maestro:Predicate ; maestro:arguments ( "?x" ) ; rdfs:label "loud"@en .
                """);

    assertThat(home.vocabulary().iri("Oven")).contains("https://w3id.org/maestro/home/flat#Oven");
    assertThat(home.individuals()).containsKey("Glass");
    assertThat(home.vocabulary().classes()).doesNotContainKey("Glass").containsKey("Hob");
    assertThat(home.vocabulary().predicate("volume").orElseThrow().fluent()).isFalse();
    assertThat(home.vocabulary().features()).doesNotContainKey("setVolume");
    assertThat(home.vocabulary().classes()).doesNotContainKey("MediaPlayer");
  }

  @Test
  void aStereoIsBuiltOnTheVolumeAndGoesWithIt() {
    assertThatThrownBy(
            () ->
                flat(
                    STEREO
                        + "home:volume a maestro:Fluent ; maestro:arguments ( \"?x\" ) ; rdfs:label \"litres\"@en ."))
        .isInstanceOf(HomeFaultException.class)
        .hasMessageContaining("Stereo");
  }

  @Test
  void anotherProcessHasThemToo() {
    Home home = flat(STEREO);
    String said = new DescriptionWriter(home).write(home.devices().get("stereo"));

    assertThat(loader.vocabularyWith(home.words())).isEqualTo(home.vocabulary());
    assertThat(
            new DescriptionReader(loader.vocabularyWith(home.words()), home.words())
                .read(said, "stereo"))
        .isEqualTo(home.devices().get("stereo"));
  }

  @Test
  void aFeatureChoosesAmongTheValuesOfTheSettingThatItSets() {
    Device stereo = flat(STEREO).devices().get("stereo");

    assertThat(values(stereo, "changeDisc"))
        .isEqualTo(IntStream.rangeClosed(1, 5).mapToObj(Term.Number::new).toList());
    assertThat(values(stereo, "setVolume")).hasSize(101);
    assertThat(stereo.reports()).containsEntry("disc", "(= (disc ?self) ?disc)");
  }

  @Test
  void aDeviceMayBeSetOtherwiseThanItsClass() {
    Device stereo =
        flat(STEREO.replace(
                " .\n",
                """
                     ; maestro:setting [ maestro:name "disc" ; maestro:fact "(= (disc ?self) ?disc)" ;
                      maestro:lowest 1 ; maestro:highest 3 ; maestro:grain 1 ] .
                    """))
            .devices()
            .get("stereo");

    assertThat(values(stereo, "changeDisc")).hasSize(3);
  }

  @Test
  void whatCannotBeSetIsToldWithItsLine() {
    assertThatThrownBy(
            () ->
                flat(
                    """
                    home:dial a :Stereo ;
                      maestro:setting [ maestro:name "volume" ; maestro:fact "(= (volume ?self) ?volume)" ;
                        maestro:lowest 0 ; maestro:highest 100 ; maestro:grain 0.01 ] .
                    """))
        .hasMessageContaining(
            "dial maestro:setting gives volume 10001 values, more than 1000; write a greater"
                + " maestro:grain, or leave it away");
    assertThatThrownBy(
            () ->
                flat(
                    """
                    home:dial a :Stereo ;
                      maestro:setting [ maestro:name "volume" ; maestro:fact "(= (volume ?self) ?volume)" ;
                        maestro:lowest 10 ; maestro:highest 5 ] .
                    """))
        .hasMessageContaining("is more than maestro:highest; exchange both numbers");
  }

  private static List<Term> values(Device device, String feature) {
    return device.features().stream()
        .filter(offered -> offered.name().equals(feature))
        .map(FeatureType::inputs)
        .map(inputs -> inputs.get(0).oneOf())
        .findFirst()
        .orElseThrow();
  }
}
