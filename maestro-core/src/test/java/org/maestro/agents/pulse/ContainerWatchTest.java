package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.SteppedClock;

class ContainerWatchTest {
  private static final HeartbeatSettings SETTINGS = HeartbeatSettings.standard();

  private static final Report NOTHING = Report.read("");

  private final SteppedClock clock = new SteppedClock();
  private final List<String> told = new ArrayList<>();
  private final ContainerWatch watch = new ContainerWatch(clock, SETTINGS, new Told());

  private final class Told implements Watcher {
    @Override
    public void container(String name, Condition now, Duration silence) {
      told.add("%s %s after %d ms".formatted(name, now, silence.toMillis()));
    }

    @Override
    public void agent(String agent, Condition now, Duration silence) {
      told.add("agent %s %s".formatted(agent, now));
    }
  }

  @BeforeEach
  void begin() {
    watch.begin();
  }

  @Test
  void aContainerThatFreezesIsSuspectedAndLostAndStaysSoWhenItThaws() {
    beat("lights", "first life", 3);
    pass(Duration.ofSeconds(6));

    assertThat(told).containsExactly("lights SUSPECTED after 2000 ms", "lights LOST after 4000 ms");
    assertThat(watch.heard("lights", "first life", NOTHING).welcome()).isFalse();
  }

  @Test
  void aContainerOfTheSameNameMayJoinAndTheFormerOneStaysShutOut() {
    beat("lights", "first life", 3);
    pass(Duration.ofSeconds(6));

    assertThat(watch.heard("lights", "second life", NOTHING).welcome()).isTrue();
    assertThat(watch.heard("lights", "first life", NOTHING).welcome()).isFalse();
    beat("lights", "second life", 20);
    assertThat(watch.containers()).containsEntry("lights", Condition.ALIVE);
  }

  /** JADE has noticed that its process was killed. */
  @Test
  void aContainerThatEndedIsNotMissedAndNotWelcomeAnyMore() {
    beat("lights", "first life", 3);
    watch.ended("lights");
    pass(Duration.ofSeconds(10));

    assertThat(told).isEmpty();
    assertThat(watch.heard("lights", "first life", NOTHING).welcome()).isFalse();
  }

  @Test
  void anAgentThatHangsInALivingContainerIsSuspected() {
    for (int beats = 0; beats < 12; beats++) {
      watch.heard("lights", "life", report(beats < 2 ? "" : "\n" + beats * 500 + " lamp one"));
      pass(SETTINGS.period());
    }
    watch.heard("lights", "life", NOTHING);
    pass(SETTINGS.period());

    assertThat(told)
        .containsExactly("agent lamp one SUSPECTED", "agent lamp one LOST", "agent lamp one ALIVE");
  }

  private static Report report(String text) {
    return Report.read(text);
  }

  private void beat(String container, String life, int times) {
    for (int beats = 0; beats < times; beats++) {
      watch.heard(container, life, NOTHING);
      if (beats < times - 1) {
        pass(SETTINGS.period());
      }
    }
  }

  private void pass(Duration duration) {
    boolean[] passed = {false};
    clock.schedule(duration, "test", () -> passed[0] = true);
    clock.runUntil(() -> passed[0], duration.plusSeconds(1));
  }
}
