package org.maestro.platform.failover;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.maestro.deployment.AgentStart;

/** Who has agents that are on their way to another process. */
class MigrationReservationsTest {
  private final MigrationReservations handing = new MigrationReservations();
  private final List<AgentStart> lamps =
      List.of(AgentStart.of("lamp-1", "lights"), AgentStart.of("lamp-2", "lights"));

  @Test
  void whatNobodyHasBegunIsGivenBackOnce() {
    asked("asker");

    assertThat(handing.isAsker("asker")).isTrue();
    assertThat(handing.givenUp("asker"))
        .isEqualTo(Map.of("lamp-1", "lamp-1's", "lamp-2", "lamp-2's"));
    assertThat(handing.isAwaiting("lamp-1")).isFalse();
    assertThat(handing.isAsker("asker")).isFalse();
    assertThat(handing.givenUp("asker")).isEmpty();
  }

  @Test
  void whatHasBegunIsNotGivenBack() {
    asked("asker");
    assertThat(handing.joined("lights")).isEqualTo(lamps);
    assertThat(handing.isAwaiting("lamp-1")).isFalse();
    handing.begun("lamp-1");

    assertThat(handing.givenUp("asker")).containsOnlyKeys("lamp-2");
  }

  @Test
  void whoAsksNextHasThem() {
    asked("first");
    asked("second");

    assertThat(handing.isAsker("first")).isFalse();
    assertThat(handing.givenUp("first")).isEmpty();
    assertThat(handing.isAwaiting("lamp-1")).isTrue();
  }

  /** An agent that still ends must not begin. */
  @Test
  void nothingIsGivenBackBeforeItHasEnded() {
    handing.begin("lights", "asker", lamps, start -> start.agent() + "'s");
    CompletableFuture<Map<String, String>> back =
        CompletableFuture.supplyAsync(() -> handing.givenUp("asker"));
    assertThat(back).isNotDone();
    handing.admitted("lights");

    assertThat(back.join()).hasSize(2);
  }

  private void asked(String asker) {
    handing.begin("lights", asker, lamps, start -> start.agent() + "'s");
    handing.admitted("lights");
  }
}
