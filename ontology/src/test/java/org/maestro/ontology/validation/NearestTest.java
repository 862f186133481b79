package org.maestro.ontology.validation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;

/** What somebody may have meant who wrote a name that nobody knows. */
class NearestTest {

  @Test
  void aSlipIsForgiven() {
    assertThat(Nearest.to("usualyIn", List.of("usuallyIn", "in"))).contains("usuallyIn");
    assertThat(Nearest.to("gaol", List.of("goal", "goals"))).contains("goal");
  }

  @Test
  void ofTwoAsNearTheOneThatBeginsMoreAlikeIsMeant() {
    assertThat(Nearest.to("sowed", List.of("power", "sown"))).contains("sown");
  }

  @Test
  void whatDiffersMoreThanByASlipHasToBeginAlike() {
    assertThat(Nearest.to("sowed", List.of("power"))).isEmpty();
    assertThat(Nearest.to("powre", List.of("power"))).contains("power");
  }
}
