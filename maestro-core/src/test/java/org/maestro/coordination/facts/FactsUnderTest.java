package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.sl.Term;

/**
 * What was known under a step's condition, so that it can be told whether that is otherwise now.
 */
class FactsUnderTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();

  @Test
  void eachGroundFactHasALine() {
    assertThat(
            FactsUnder.of(
                home.formula(
                    """
                    (and (in ?self ?zone) (or (in Cup zone-a) (in Bob ?zone))
                      (>= (illuminance ?zone) 72) (<= (illuminance zone-a) 100)
                      (exists (?x - Item) (in ?x rose)) (exists (?z - Zone) (< (illuminance ?z) 1)))"""),
                Map.of("self", new Term.Name("rose"), "zone", new Term.Name("zone-b")),
                home.now()))
        .isEqualTo(
            """
            (illuminance zone-a)=UNKNOWN
            (illuminance zone-b)=17
            (in Bob zone-b)=UNKNOWN
            (in Cup zone-a)=FALSE
            (in rose zone-b)=TRUE""");
  }

  @Test
  void othersAreAddedButNoneIsReplaced() {
    assertThat(
            FactsUnder.with(
                "(in Cup zone-b)=FALSE",
                List.of(
                    home.atom("(in Cup zone-b)"),
                    home.atom("(in rose zone-b)"),
                    home.atom("(illuminance zone-b)")),
                home.now()))
        .isEqualTo(
            """
            (illuminance zone-b)=17
            (in Cup zone-b)=FALSE
            (in rose zone-b)=TRUE""");
  }

  @Test
  void whatWasTaughtMeanwhileIsAsItIsAfterIt() {
    assertThat(
            FactsUnder.asTaught(
                "(in Cup a)=TRUE\n(in Bob a)=TRUE",
                "(in Cup a)=FALSE\n(in Bob a)=FALSE\n(in Ann a)=TRUE",
                List.of(home.atom("(in Cup a)"), home.atom("(in Ann b)"))))
        .isEqualTo("(in Bob a)=TRUE\n(in Cup a)=FALSE");
  }

  @ParameterizedTest
  @CsvSource({
    "TRUE, TRUE, true",
    "TRUE, FALSE, false",
    "100, 104, true",
    "95, 100, true",
    "100, 95, true",
    "94, 100, false",
    "100, 94, false",
    "-100, -104, true",
    "-100, 100, false",
    ".5, 0.51, true",
    "0, 0.1, false",
    "100, UNKNOWN, false",
    "UNKNOWN, 100, false",
    "UNKNOWN, UNKNOWN, true"
  })
  void numbersMayDifferAsReadingsDo(String some, String other, boolean same) {
    assertThat(FactsUnder.areSame("(p a)=x\n(f a)=" + some, "(f a)=" + other + "\n(p a)=x"))
        .isEqualTo(same);
  }

  @Test
  void factsThatAreNotSpokenOfThereAreADifference() {
    assertThat(FactsUnder.areSame("(p a)=TRUE", "(p a)=TRUE\n(p b)=TRUE")).isFalse();
    assertThat(FactsUnder.areSame("(p a)=TRUE\n(p b)=TRUE", "(p a)=TRUE")).isFalse();
    assertThat(FactsUnder.areSame("", "")).isTrue();
    assertThat(FactsUnder.areSame("", "(p a)=TRUE")).isFalse();
  }
}
