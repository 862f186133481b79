package org.maestro.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.maestro.random.Building;

class WarmDecisionsTest {

  /** All of them have plans: it fails where one has none. */
  @ParameterizedTest
  @EnumSource(WarmDecisions.Known.class)
  void decidesWhateverIsKnown(WarmDecisions.Known known) {
    WarmDecisions decisions = new WarmDecisions(new Building(40, 1, 1));

    assertThat(
            decisions.median(
                known,
                List.of(
                    "(nextTo Thing0 Person0)", "(>= (illuminance z3) 200)", "(canSee ?a Thing1)")))
        .isPositive();
  }
}
