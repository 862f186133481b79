package org.maestro.platform.hosts;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.deployment.Provision;

class PlacingTest {
  private static final Placing.Host OWN = host("", true, 5);
  private static final Placing.Host ATTIC = host("attic", false, 1, "microphone", "memory 256");
  private static final Placing.Host CELLAR = host("cellar", false, 3, "microphone", "memory 1024");

  @Test
  void theOnlyHostThatFitsIsChosen() {
    assertThat(Placing.choose(needs("memory 512"), List.of(OWN, ATTIC, CELLAR))).contains(CELLAR);
    assertThat(Placing.choose(needs("serial-port"), List.of(OWN, ATTIC, CELLAR))).isEmpty();
  }

  @Test
  void ofSeveralThePlatformsOwnThenTheOneWithFewestAgents() {
    assertThat(Placing.choose(needs(), List.of(CELLAR, ATTIC, OWN))).contains(OWN);
    assertThat(Placing.choose(needs("microphone"), List.of(CELLAR, ATTIC))).contains(ATTIC);
  }

  @Test
  void whatIsLackingIsToldInWords() {
    assertThat(Provision.of(List.of("memory 256")).lacks(needs("memory 512", "microphone")))
        .containsExactly("memory 512", "microphone");
    assertThat(Provision.of(List.of("memory")).lacks(needs("memory 512"))).isEmpty();
    assertThat(needs("microphone", "memory 512").inWords()).isEqualTo("memory 512 and microphone");
    assertThatThrownBy(() -> needs("a lot of memory")).hasMessageContaining("\"memory 512\"");
  }

  @Test
  void whoDiesAgainAndAgainIsStartedMoreAndMoreSeldom() {
    Backoff backoff = new Backoff(Duration.ofSeconds(1), Duration.ofSeconds(8));
    Duration now = Duration.ZERO;
    for (long expected : new long[] {0, 1, 2, 4, 8, 8}) {
      Duration delay = backoff.died("attic", now);
      assertThat(delay).hasSeconds(expected);
      now = now.plus(delay).plusSeconds(1);
    }
    assertThat(backoff.died("cellar", now)).isZero();
    assertThat(backoff.died("attic", now.plusSeconds(30))).as("after a long life").isZero();
  }

  private static Provision needs(String... needs) {
    return Provision.of(List.of(needs));
  }

  private static Placing.Host host(String name, boolean own, int agents, String... provides) {
    return new Placing.Host(name, Provision.of(List.of(provides)), own, agents);
  }
}
