package org.maestro.knowledge.learning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.knowledge.Household;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.sl.Term;

/** Nothing is darker than dark, whatever a sensor says. */
class LeastValueTest {
  private final Household home = new Household();

  @Test
  void aResultBelowAllThatCanBeTeachesNothing() {
    measures(-3);
    assertThat(home.number("(illuminance zone-a)")).isEmpty();

    measures(17);
    assertThat(home.number("(illuminance zone-a)")).hasValue(17);
    home.close();
  }

  private void measures(double lux) {
    home.knowledge.learn(
        new FeatureRun(
            "lamp-b1",
            Household.feature("(sense (illuminance zone-a))", "(assign (illuminance zone-a) ?lux)"),
            Map.of(),
            true,
            Map.of("lux", new Term.Number(lux)),
            List.of(),
            Optional.empty(),
            true,
            Optional.empty()));
  }
}
