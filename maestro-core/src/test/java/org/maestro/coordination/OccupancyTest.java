package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.junit.jupiter.api.Test;

class OccupancyTest {
  private final Occupancy occupancy = new Occupancy();

  @Test
  void aComponentHasOneHolder() {
    occupancy.take("rose", Set.of("base", "arm"), "G1");

    assertThat(occupancy.isFree("rose", Set.of("base"))).isFalse();
    assertThat(occupancy.isFree("tim", Set.of("base"))).isTrue();
    assertThat(occupancy.holders("rose", Set.of("arm"))).isEqualTo("the arm of rose is held by G1");
  }

  @Test
  void onlyTheHolderReleases() {
    occupancy.take("rose", Set.of("base"), "G1");
    occupancy.release("rose", Set.of("base"), "G2");
    assertThat(occupancy.isFree("rose", Set.of("base"))).isFalse();

    occupancy.release("rose", Set.of("base"), "G1");
    assertThat(occupancy.isFree("rose", Set.of("base"))).isTrue();
  }

  @Test
  void whatOccupiesNothingIsAlwaysFree() {
    occupancy.take("cam-b", Set.of(), "G1");

    assertThat(occupancy.isFree("cam-b", Set.of())).isTrue();
  }
}
