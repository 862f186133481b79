package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/** Conditions of any individual are asked again, as few of the facts that concern them matter. */
class QuantifiedConditionsTest {
  private final KnownHome home = KnownHome.withRoseAtTheCup();
  private final ProgressedState holding =
      ProgressedState.of(
          home.now(), home.vocabulary, home.step("rose", "pick", "object=Cup", "zone=zone-b"));

  @Test
  void aChangeIsToldOnce() {
    QuantifiedConditions conditions =
        conditions("(not (exists (?x - Item) (in ?x rose)))", "(in Cup zone-b)");

    assertThat(conditions.haveChanged(home.now())).isFalse();
    assertThat(conditions.haveChanged(holding)).isTrue();
    assertThat(conditions.haveChanged(holding)).isFalse();
    assertThat(conditions.haveChanged(home.now())).as("back again").isTrue();
  }

  @Test
  void eachIsAskedEachTime() {
    QuantifiedConditions conditions =
        conditions("(exists (?x - Item) (in ?x rose))", "(forall (?x - Item) (in ?x zone-b))");

    assertThat(conditions.haveChanged(holding)).isTrue();
    assertThat(conditions.haveChanged(holding)).as("both have been asked").isFalse();
  }

  @Test
  void thoseThatNameTheirIndividualsAreLeftOut() {
    assertThat(conditions("(in Cup zone-b)").haveChanged(holding)).isFalse();
  }

  private QuantifiedConditions conditions(String... formulas) {
    return new QuantifiedConditions(Stream.of(formulas).map(home::formula).toList(), home.now());
  }
}
