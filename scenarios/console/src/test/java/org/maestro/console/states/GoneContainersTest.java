package org.maestro.console.states;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.agents.pulse.Condition;

class GoneContainersTest {
  private static final Observed.Container OWN = container("lights", true);
  private static final Observed.Container JOINED = container("robots", false);

  private Instant now = Instant.EPOCH;
  private final GoneContainers gone = new GoneContainers(() -> now);

  private static Observed.Container container(String name, boolean isOwn) {
    return new Observed.Container(
        name, "process 1", isOwn, Condition.ALIVE, Duration.ofMillis(200), List.of("rose"));
  }

  @Test
  void whoWasThereAndIsNotIsLostThoughOneOfOurOwnHasItsName() {
    assertThat(gone.without(List.of(OWN, JOINED))).isEmpty();
    now = now.plusMillis(800);

    assertThat(gone.without(List.of(OWN, container("robots", true))))
        .containsExactly(
            new Observed.Container(
                "robots",
                "process 1",
                false,
                Condition.LOST,
                Duration.ofSeconds(1),
                List.of("rose")));
  }

  @Test
  void whoIsBackIsNotMissedAndWhoIsLongGoneNeither() {
    gone.without(List.of(JOINED));
    assertThat(gone.without(List.of())).hasSize(1);
    assertThat(gone.without(List.of(JOINED))).isEmpty();
    assertThat(gone.without(List.of())).hasSize(1);
    now = now.plus(GoneContainers.KEPT);
    assertThat(gone.without(List.of())).isEmpty();
  }
}
