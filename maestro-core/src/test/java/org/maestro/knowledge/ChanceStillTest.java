package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** What was known once says where to look first, the less the longer ago. */
class ChanceStillTest {
  private final Household household = new Household();

  private double chance(String atom) {
    return household.knowledge.snapshot().chanceStill((Formula.Atom) SlParser.formula(atom));
  }

  @Test
  void fadesWithAge() {
    household.knowledge.state(Household.CAMERA, List.of("(in Cup zone-b)"));
    household.clock.run(Duration.ofMinutes(10));
    assertThat(chance("(in Cup zone-b)")).isCloseTo(0.5, within(0.001));
    household.clock.run(Duration.ofMinutes(20));
    assertThat(chance("(in Cup zone-b)")).isCloseTo(0.25, within(0.001));
    assertThat(chance("(in Cup zone-a)")).isZero();
    assertThat(chance("(in Bob zone-b)")).isZero();
  }

  @Test
  void isNoneWhereItWasLookedForInVain() {
    household.knowledge.state(Household.CAMERA, List.of("(in Cup zone-b)"));
    household.clock.run(Duration.ofMinutes(11));
    household.knowledge.state(Household.CAMERA, List.of("(not (in Cup zone-b))"));
    assertThat(chance("(in Cup zone-b)")).isZero();
  }
}
