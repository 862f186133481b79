package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/** What follows from where things are. */
class ReckonedFromPlacesTest {
  private final KnownHome home = KnownHome.ofBob();
  private final ReckonedFromPlaces reckoned = new ReckonedFromPlaces(home.vocabulary);

  @ParameterizedTest
  @CsvSource({
    "distance, true",
    "inside, true",
    "in, false",
    "illuminance, false",
    "handFree, false",
    "unheardOf, false"
  })
  void wordsThatAreComputed(String word, boolean isReckoned) {
    assertThat(reckoned.isReckoned(word)).isEqualTo(isReckoned);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "(<= (distance Cup Bob) 1) | true",
        "(<= (distance zone-a Bob) 1) | true",
        "(<= (distance zone-a zone-b) 1) | false",
        "(<= (distance ?x zone-b) 1) | true",
        "(inside Cup zone-a) | true",
        "(inside cam-a zone-a) | false",
        "(inside rose zone-a) | true",
        "(in Cup zone-a) | false",
        "(and (in Cup zone-a) (not (inside Bob zone-a))) | true"
      })
  void onlyOfWhatCanBeElsewhere(String formula, boolean changes) {
    assertThat(reckoned.isIn(home.formula(formula), home.now())).isEqualTo(changes);
  }

  @Test
  void whatStandsWhereItStandsNeedNotBeSeen() {
    assertThat(SlPrinter.print(reckoned.seenIfThing(SlParser.term("Cup"))))
        .isEqualTo("(or (seen% Cup) (not (Thing Cup)))");
  }
}
