package org.maestro.coordination.facts;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.sl.Effect;
import org.maestro.sl.SlParser;

/** The names that formulas and effects speak of. */
class SymbolsTest {
  private static final Effect EFFECT =
      SlParser.effect(
          """
          (and (in Cup rose) (not (nextTo Cup Bob))
            (when (open door) (and (sense (glare a)) (when (locked door) (covers cam a))))
            (forall (?z) (increase (lux ?z) (* 2 (level lamp))))
            (sense (mass Cup)))""",
          name -> name.equals("lux") || name.equals("mass"));

  @Test
  void aFormulaSpeaksOfAllThatStandsInIt() {
    assertThat(
            Symbols.of(
                SlParser.formula(
                    """
                    (and (in Cup a) (not (>= (lux a) (least cam))) (unknown (glare a))
                      (exists (?x) (imply (open ?x) (unknown (mass Cup)))))""",
                    "mass"::equals)))
        .containsExactly("glare", "in", "least", "lux", "mass", "open");
  }

  @Test
  void anEffectChangesWhatItAddsTakesAwayReckonsAndSenses() {
    assertThat(Symbols.changedBy(EFFECT))
        .containsExactly("covers", "glare", "in", "lux", "mass", "nextTo");
  }

  @Test
  void anEffectReadsItsConditionsAndTheValuesItSets() {
    assertThat(Symbols.readBy(EFFECT)).containsExactly("level", "locked", "open");
  }
}
