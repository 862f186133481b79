package org.maestro.sl;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;

class TermTest {

  /** Maps by such pairs are asked for at every step of planning. */
  @Test
  void pairsOfNamesThatAreNumberedThroughHaveDifferentHashCodes() {
    Set<Integer> hashCodes = new HashSet<>();
    for (int zone = 0; zone < 200; zone++) {
      for (int camera = 0; camera < 200; camera++) {
        hashCodes.add(
            List.<Term>of(new Term.Name("z" + zone), new Term.Name("cam" + camera)).hashCode());
      }
    }
    assertThat(hashCodes).hasSizeGreaterThan(39_900);
  }
}
