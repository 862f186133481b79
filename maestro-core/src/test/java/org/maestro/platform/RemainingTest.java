package org.maestro.platform;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collection;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** ADE, 3.2 (A38): "There is a problem with ..., so you will need to use ...". */
class RemainingTest {
  private final Home home =
      new HomeLoader()
          .load(
              """
              @prefix : <https://w3id.org/maestro/domain#> .
              @prefix home: <https://w3id.org/maestro/home/words#> .
              @prefix maestro: <https://w3id.org/maestro#> .
              @prefix owl: <http://www.w3.org/2002/07/owl#> .
              @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
              <https://w3id.org/maestro/home/words> a maestro:Home ; rdfs:label "words"@en .
              :understand a maestro:Action ; rdfs:label "understand"@en ;
                maestro:sentence "{self} understands" ; maestro:cost "1" ; maestro:seconds "1" .
              :listen a maestro:Action ; rdfs:label "listen"@en ;
                maestro:sentence "{self} listens" ; maestro:cost "1" ; maestro:seconds "1" .
              :Ear a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "ear"@en ;
                maestro:offers :understand , :listen .
              :Keyboard a owl:Class ; rdfs:subClassOf maestro:Device ; rdfs:label "keyboard"@en ;
                maestro:offers :understand .
              home:ear a :Ear .
              home:keyboard a :Keyboard .
              """,
              "words.ttl");

  @Test
  void saysWhoElseDoesItAndWhatNobodyDoesAnyMore() {
    assertThat(Remaining.inWords(device("ear"), List.of(device("ear"), device("keyboard"))))
        .isEqualTo("use keyboard for understand; nobody else can listen");
  }

  @Test
  void whereNobodyIsLeftNothingIsRecommended() {
    Collection<Device> nobody = List.of();

    assertThat(Remaining.inWords(device("keyboard"), nobody))
        .isEqualTo("nobody else can understand");
  }

  private Device device(String id) {
    return home.devices().get(id);
  }
}
