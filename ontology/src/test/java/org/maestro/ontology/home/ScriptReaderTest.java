package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;

/**
 * Scripts are read with a home, and what they cannot do is told then, with its line and its cure.
 */
class ScriptReaderTest {
  private static final String BOB = ShippedHomes.text("bob.ttl");

  private static Home load(String more) {
    return new HomeLoader().load(BOB + "\n" + more, "bob.ttl");
  }

  private static String script(String arguments, String body) {
    return """
        home:other a maestro:Script ; maestro:arguments ( "?z - Zone" ) ; maestro:body "(achieve (in rose ?z))" .
        home:tried a maestro:Script ; maestro:arguments ( %s ) ;
          maestro:body \"""%s\""" .
        """
        .formatted(arguments, body);
  }

  @Test
  void aScriptIsReadWithItsWorth() {
    Home home =
        load(
            """
            @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .
            home:prepare a maestro:Script ; rdfs:label "prepare a room"@en ;
              maestro:arguments ( "?room - Zone" "?who - Person" "?lux - xsd:double" ) ;
              maestro:benefit "(* 2 ?lux)" ; maestro:chance 0.9 ; maestro:allowed "PT10M"^^xsd:duration ;
              maestro:body \"""(seq (achieve (>= (illuminance ?room) ?lux))
                (try (do move rose :to ?room) (recover (run prepare ?room ?who 10))))\""" .
            """);

    Script script = home.scripts().get("prepare");
    assertThat(script.form()).isEqualTo("(prepare ?room - Zone ?who - Person ?lux - double)");
    assertThat(script.label()).isEqualTo("prepare a room");
    assertThat(script.benefit()).contains(SlParser.expression("(* 2 ?lux)"));
    assertThat(script.chance()).contains(0.9);
    assertThat(script.allowed()).contains(Duration.ofMinutes(10));
    assertThat(SlPrinter.print(script.body()))
        .isEqualTo(
            "(seq (achieve (>= (illuminance ?room) ?lux)) (try (do move rose :to ?room)"
                + " (recover (run prepare ?room ?who 10))))");
    assertThat(home.individuals()).doesNotContainKey("prepare");
    assertThat(WordList.of(home))
        .filteredOn(entry -> entry.kind().equals(WordList.SCRIPT))
        .extracting(WordList.Entry::meaning)
        .containsExactly("prepare a room; worth (* 2 ?lux)");
  }

  @Test
  void aHomeWithoutScriptsHasNone() {
    assertThat(load("").scripts()).isEmpty();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "(achive (in rose zone-a)) | a step",
        "(seq (achieve (in rose zone-a)) | the end of the text",
        "(achieve (inn rose zone-a)) | the unknown predicate inn",
        "(achieve (>= (iluminance zone-a) 5)) | iluminance",
        "(achieve (in rosa zone-a)) | rosa",
        "(achieve (in ?x zone-a)) | ?x",
        "(achieve (in rose Bob)) | Bob",
        "(seq (let ?x (one (?z - Zone) (in rose ?z)) (wait 1)) (achieve (in rose ?x))) | ?x",
        "(foreach (?l) (in ?l zone-a) (wait 1)) | give it a class",
        "(foreach (?l - Lmap) (in ?l zone-a) (wait 1)) | Lmap",
        "(run othr zone-a) | write other, if that is meant",
        "(run other) | gives other 0 arguments",
        "(run other Bob) | gives Bob for ?z of other, which cannot be that",
        "(run tried) | runs itself without an end",
        "(seq (wait 1) (run tried)) | runs itself without an end",
        "(do mov rose :to zone-a) | calls the unknown feature mov",
        "(do move lamp-a1 :to zone-a) | does not offer it",
        "(do move Bob :to zone-a) | is no device",
        "(do move rose :too zone-a) | too",
        "(do move rose :to Bob) | Bob",
        "(do adjustLight lamp-a1 :level bright) | bright",
        "(wait (inn rose zone-a)) | the unknown predicate inn",
        "(assert (inn rose zone-a)) | the unknown predicate inn",
        "(if (inn rose zone-a) (wait 1)) | the unknown predicate inn",
        "(while (in rose nowhere) (wait 1)) | nowhere",
        "(let ?v (value (chargee rose)) (wait ?v)) | chargee",
        "(return ?nothing) | ?nothing",
      })
  void whatAScriptCannotDoIsToldWhenItIsLoaded(String body, String part) {
    HomeFaultException faults =
        catchThrowableOfType(HomeFaultException.class, () -> load(script("", body)));

    assertThat(faults).as(body).isNotNull();
    assertThat(faults.faults())
        .as(body)
        .allMatch(fault -> fault.line() > BOB.lines().count(), "its line")
        .anyMatch(fault -> fault.toString().contains(part));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      value = {
        "home:rose a maestro:Script ; maestro:body \"(wait 1)\" . | ",
        "home:s a maestro:Script . | is missing",
        "home:s a maestro:Script ; maestro:body \"(wait 1)\" , \"(wait 2)\" . | more than once",
        "home:s a maestro:Script ; maestro:body \"(wait 1)\" ; maestro:chance 1.5 . | from 0 to 1",
        "home:s a maestro:Script ; maestro:body \"(wait 1)\" ; maestro:benefit \"(lux\" . | lux",
        "home:s a maestro:Script ; maestro:body \"(wait 1)\" ; maestro:benefit \"(* 2 ?x)\" . | ?x",
        "home:s a maestro:Script ; maestro:body \"(wait 1)\" ; maestro:arguments ( \"?x\" ) ."
            + " | does not say what ?x is",
        "home:s a maestro:Script ; maestro:body \"(wait 1)\" ; maestro:arguments ( \"?x - Zoon\" ) ."
            + " | write Zone, if that is meant",
      })
  void whatAScriptLacksIsToldToo(String turtle, String part) {
    HomeFaultException faults = catchThrowableOfType(HomeFaultException.class, () -> load(turtle));

    assertThat(faults).as(turtle).isNotNull();
    assertThat(faults.faults())
        .as(turtle)
        .anyMatch(fault -> fault.toString().contains(Optional.ofNullable(part).orElse("")));
  }

  /** A run under a condition may end. */
  @Test
  void scriptsMayRunEachOtherUnderAcondition() {
    Home home =
        load(
            """
            home:a a maestro:Script ; maestro:body "(if (in rose zone-a) (run b))" .
            home:b a maestro:Script ; maestro:body "(seq (achieve (in rose zone-a)) (run a))" .
            """);

    assertThat(home.scripts().keySet()).containsExactlyElementsOf(List.of("a", "b"));
  }
}
