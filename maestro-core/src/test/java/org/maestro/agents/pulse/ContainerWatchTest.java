package org.maestro.agents.pulse;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.maestro.rats.time.SteppedClock;

class ContainerWatchTest {
  private static final HeartbeatSettings SETTINGS = HeartbeatSettings.standard();

  private final SteppedClock clock = new SteppedClock();
  private final List<String> told = new ArrayList<>();
  private final ContainerWatch watch =
      new ContainerWatch(clock, SETTINGS, "Main-Container", new Told());

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
    assertThat(hear("lights", "first life", "")).isFalse();
  }

  @Test
  void aContainerOfTheSameNameMayJoinAndTheFormerOneStaysShutOut() {
    beat("lights", "first life", 3);
    pass(Duration.ofSeconds(6));

    assertThat(hear("lights", "second life", "")).isTrue();
    assertThat(hear("lights", "first life", "")).isFalse();
    beat("lights", "second life", 20);
    assertThat(watch.signs().conditions()).containsEntry("lights", Condition.ALIVE);
  }

  /** JADE has noticed that its process was killed. */
  @Test
  void aContainerThatEndedIsNotMissedAndNotWelcomeAnyMore() {
    beat("lights", "first life", 3);
    watch.ended("lights");
    pass(Duration.ofSeconds(10));

    assertThat(told).isEmpty();
    assertThat(hear("lights", "first life", "")).isFalse();
  }

  @Test
  void anAgentThatHangsInALivingContainerIsSuspected() {
    for (int beats = 0; beats < 28; beats++) {
      hear("lights", "life", beats < 2 ? "" : beats * 500 + " lamp one");
      pass(SETTINGS.period());
    }
    hear("lights", "life", "");
    pass(SETTINGS.period());

    assertThat(told)
        .containsExactly("agent lamp one SUSPECTED", "agent lamp one LOST", "agent lamp one ALIVE");
  }

  /** Ten thousand agents that all read at once wait for each other, and are not replaced for it. */
  @Test
  void whereManyAgentsAreSilentAtOnceNoneHangs() {
    for (int beats = 0; beats < 40; beats++) {
      StringBuilder silences = new StringBuilder();
      for (int lamp = 0; lamp < 9; lamp++) {
        silences.append("%d lamp-%d%n".formatted(beats * 500, lamp));
      }
      hear("lights", "life", beats < 2 ? "" : silences.toString());
      pass(SETTINGS.period());
    }

    assertThat(told).hasSize(9).allMatch(line -> line.endsWith("SUSPECTED"));
  }

  @Test
  void howLongSomebodyIsSilentIsTold() {
    hear("lights", "life", "");
    pass(SETTINGS.period());
    hear("robots", "other life", "");
    pass(Duration.ofMillis(700));

    Signs signs = watch.signs();
    assertThat(signs.timing()).isEqualTo(SETTINGS);
    assertThat(signs.containers())
        .containsEntry("lights", new LifeSign(Condition.ALIVE, Duration.ofMillis(1_200)))
        .containsEntry("robots", new LifeSign(Condition.ALIVE, Duration.ofMillis(700)));
  }

  @Test
  void anAgentThatDoesNothingIsNamed() {
    for (int beats = 0; beats < 8; beats++) {
      hear("lights", "life", beats < 2 ? "" : beats * 500 + " lamp one");
      pass(SETTINGS.period());
    }

    assertThat(watch.signs().agents()).containsExactly(Map.entry("lamp one", Condition.SUSPECTED));
  }

  /** A platform that has taken over does not know it. */
  @Test
  void aContainerOfAnotherPlatformIsNotWelcome() {
    Beat beat = Beat.read("a-life - lights\nb-life - robots\n");

    assertThat(watch.heard(beat, Set.of("robots")).givenUp()).containsExactly("a-life");
    assertThat(watch.signs().conditions()).containsOnlyKeys("robots");
  }

  /** They have been promised that nobody acts in their place before. */
  @Test
  void whereAllAreSlowTheyMayActForLonger() {
    Beat beat = Beat.read("a-life - lights\nb-life - robots\n");
    Duration usual = watch.heard(beat, Set.of("lights", "robots")).lease();
    for (int beats = 0; beats < 4; beats++) {
      pass(Duration.ofMillis(1_500));
      watch.heard(beat, Set.of("lights", "robots"));
    }
    pass(SETTINGS.period());

    assertThat(usual).isEqualTo(SETTINGS.lease());
    assertThat(watch.heard(beat, Set.of("lights", "robots")).lease()).isGreaterThan(usual);
  }

  private boolean hear(String container, String life, String silences) {
    String name = life.replace(' ', '-');
    Beat beat = Beat.read("%s 127.0.0.1:1099 %s\n\n%s".formatted(name, container, silences));
    return !watch.heard(beat, Set.of(container)).givenUp().contains(name);
  }

  private void beat(String container, String life, int times) {
    for (int beats = 0; beats < times; beats++) {
      hear(container, life, "");
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
