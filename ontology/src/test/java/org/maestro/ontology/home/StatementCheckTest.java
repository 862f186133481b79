package org.maestro.ontology.home;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sl.SlParser;

/** What is said wrongly in Bob's home is told with its cure. */
class StatementCheckTest {
  private static final Home HOME = ShippedHomes.bob();

  private final StatementCheck check = new StatementCheck(HOME, "The goal");

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "(foo rose) | The goal uses the unknown predicate foo; there are adjoins, busy, canSee, colour, ",
        "(foo rose) | usuallyIn, waitedFor, each written as in (canSee cam-a Bob).",
        "(>= (brightnss zone-a) 1) | unknown fluent brightnss; there are charge, daylight, ",
        "(in Cupp ?where) | Nobody knows a thing named Cupp; write Cup, if that is meant.",
        "(in Cup) | The goal gives in 1 arguments; write (in ?x - Thing ?p - Place).",
        "(Person rose Cup) | The goal gives the class Person 2 arguments",
        "(in zone-b Cup) | The goal names zone-b where a Thing is wanted, and it is none; write (in ?x - Thing ?p - Place).",
        "(in 'Cup' ?where) | The goal gives 'Cup' where a Thing is wanted, and that is no name; write Cup without quotes.",
        "(in Cup 3) | The goal gives 3 where a Place is wanted, and that is no name",
        "(in <http://example.org/Cup> zone-b) | where a Thing is wanted, and that is no name",
        "(Person 'Bob') | The goal gives 'Bob' where a Person is wanted",
        "(exists (?l - Lampe) (in ?l zone-b)) | The goal uses the unknown class Lampe",
        "(level lamp-b1) | The goal uses the number level as if it were true or false",
        "(>= (level zone-b) 1) | names zone-b where a Device is wanted, and it is none",
        "(= (level lamp-b1) rose) | The goal compares (level lamp-b1), a number, with rose",
        "(= '1' (level lamp-b1)) | a number, with '1'; write a number there",
        "(position Cup zone-a) | names zone-a where a Pose is wanted, and it is none"
      })
  void isRefused(String formula, String sentence) {
    String read = formula.replace('\'', '"');

    assertThat(check.fault(SlParser.formula(read)))
        .hasValueSatisfying(
            fault -> assertThat(fault).contains(sentence.replace('\'', '"')).endsWith("."));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '~',
      value = {
        "(in Cup zone-b)",
        "(in Cup rose)",
        "(in ?x ?where)",
        "(position Cup '1 1 0')",
        "(and (Person ?x) (nextTo ?x Cup))",
        "(= ?x rose)",
        "(= (level lamp-b1) ?n)",
        "(>= (illuminance zone-b) 72)",
        "(colour Cup ?any)",
        "(forall (?l - Device) (or (= ?l rose) (canSee ?l Cup)))"
      })
  void isUnderstood(String formula) {
    assertThat(check.fault(SlParser.formula(formula.replace('\'', '"')))).isEmpty();
  }
}
